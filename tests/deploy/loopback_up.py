"""Brings up the loopback interface of a new namespace of networks, without iproute2, and gives it a second
address: programs that ask for the addresses of the host (AI_ADDRCONFIG) do not count 127.0.0.1."""
import fcntl
import socket
import struct

SIOCSIFFLAGS = 0x8914
SIOCSIFADDR = 0x8916
UP_LOOPBACK_RUNNING = 0x1 | 0x8 | 0x40
SECOND = "10.77.0.1"
with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
    fcntl.ioctl(any_socket, SIOCSIFFLAGS, struct.pack("16sh", b"lo", UP_LOOPBACK_RUNNING))
    address = struct.pack("HH4s8x", socket.AF_INET, 0, socket.inet_aton(SECOND))
    fcntl.ioctl(any_socket, SIOCSIFADDR, struct.pack("16s16s", b"lo:1", address))
