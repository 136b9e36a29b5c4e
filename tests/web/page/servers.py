"""The programs that serve the page, and plain HTTP requests to them."""
import http.client
import os
import re
import select
import socket
import subprocess
import time

START_SECONDS = 60


class Program:
    """A program that ends with the test."""

    def __init__(self, *words, cwd=None):
        self.process = subprocess.Popen(
            list(map(str, words)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, cwd=cwd
        )
        self.said = ""

    def wait_for(self, pattern):
        """Reads output until the pattern is found; returns the match."""
        end = time.monotonic() + START_SECONDS
        output = self.process.stdout.fileno()
        while not (found := re.search(pattern, self.said)):
            ready = select.select([output], [], [], max(0, end - time.monotonic()))[0]
            data = os.read(output, 65536) if ready else b""
            if not data:
                raise AssertionError(f"{pattern} was never said; the program said: {self.said}")
            self.said += data.decode(errors="replace")
        return found

    def close(self):
        self.process.terminate()
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.process.stdout.close()


class View(Program):
    """cdctl view FOLDER."""

    def __init__(self, cdctl, folder):
        super().__init__(cdctl, "view", folder, "--no-browser")
        self.url = self.wait_for(r"http://127\.0\.0\.1:\d+/#key=[0-9a-f]+").group(0)
        self.port = int(re.search(r":(\d+)/", self.url).group(1))
        self.key = self.url.split("key=")[1]
        self.home = self.url.split("#")[0]


def ask(port, path, method="GET", headers=None, host=None):
    """Returns status, headers and body of a request."""
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=30)
    connection.putrequest(method, path, skip_host=True)
    connection.putheader("Host", host or f"127.0.0.1:{port}")
    for name, value in (headers or {}).items():
        connection.putheader(name, value)
    connection.endheaders()
    answer = connection.getresponse()
    body = answer.read()
    connection.close()
    return answer.status, dict(answer.getheaders()), body


def slow_reader(port, path, headers):
    """Asks for a path and then reads nothing; returns the socket."""
    reader = socket.create_connection(("127.0.0.1", port))
    reader.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 2048)
    lines = [f"GET {path} HTTP/1.1", f"Host: 127.0.0.1:{port}", *(f"{k}: {v}" for k, v in headers.items())]
    reader.sendall(("\r\n".join(lines) + "\r\n\r\n").encode())
    return reader
