// A connection that carries messages, over TCP or TLS.
#pragma once

#include "common/core/host/boot_id.hpp"
#include "common/core/result.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/stream.hpp"
#include "proto/channel/tls.hpp"
#include "proto/codec/message.hpp"
#include "proto/messages/party.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace cd {

/// Host and port as written by a user: "127.0.0.1:7600", "[::1]:7600", "host:7600".
struct Endpoint {
    std::string host;
    std::uint16_t port = 0;
};

/// Parses HOST:PORT. Errors: BadInput naming the expected form.
[[nodiscard]] Result<Endpoint> parse_endpoint(const std::string& text);
/// True for 127.0.0.0/8, ::1 and "localhost".
[[nodiscard]] bool is_loopback(const Endpoint& endpoint);

/// How a program is about to use an endpoint.
struct Exposure {
    bool secured = false;   ///< Uses TLS.
    bool insecure = false;  ///< --insecure was given.
    bool listening = false; ///< False: connecting.
};
/// Forbids plain TCP beyond loopback, unless `insecure` is set, which logs a warning at any log
/// level instead. Errors: Refused, naming how to get TLS, and --insecure.
[[nodiscard]] Status check_exposure(const Endpoint& endpoint, const Exposure& exposure);

/// Byte counts of one connection.
struct Traffic {
    std::uint64_t bytes_sent = 0;
    std::uint64_t bytes_received = 0;
};

/// Time limits for frames; a channel that exceeds one closes.
struct StallBounds {
    /// Longest wait for the next frame of a message that has begun to arrive.
    std::chrono::steady_clock::duration read = timing::read_stall_max;
    /// Longest time until the operating system accepts a frame.
    std::chrono::steady_clock::duration write = timing::write_stall_max;
};

/// A connection to one peer. All members run on the socket's executor, on one thread. Control
/// messages are sent before data messages. Data messages are sent in frames, so that a heartbeat
/// waits for one frame at most.
class Channel {
  public:
    /// A channel over a stream, which must be connected, and secured if the channel uses TLS.
    [[nodiscard]] static std::shared_ptr<Channel> make(std::unique_ptr<Stream> stream,
                                                       const StallBounds& stalls = {});
    Channel() = default;
    Channel(const Channel&) = delete;
    Channel& operator=(const Channel&) = delete;
    virtual ~Channel() = default;

    /// Receives the next message. Reads at most one message ahead, so that a slow caller slows the
    /// peer. Errors: Timeout (the channel stays usable); Disconnected, also for a stalled frame;
    /// Refused if the peer rejects this end's certificate; BadFrame or TooLarge for invalid bytes
    /// or a message that the peer may not send, which close the channel. The first message must be
    /// a small Hello, Welcome or Failure. One caller at a time.
    [[nodiscard]] virtual asio::awaitable<Result<Message>>
    receive(std::chrono::steady_clock::duration timeout) = 0;

    /// Sets the peer's party after its greeting. The party decides which messages the peer may
    /// send, and how large.
    virtual void expect(Party party) = 0;

    /// Queues a message, whose payload has at most the `payload_bytes_max` of its type. Never
    /// blocks; does nothing after `close`. Senders of much data await `wait_until_queued_below`.
    virtual void send(const Message& message) = 0;

    /// Bytes not yet handed to the operating system.
    [[nodiscard]] virtual std::size_t queued_bytes() const = 0;
    /// Returns when fewer than `bytes` bytes are queued, or the channel is closed.
    [[nodiscard]] virtual asio::awaitable<void> wait_until_queued_below(std::size_t bytes) = 0;

    /// Closes the connection; a waiting `receive` fails. With `flush`, queued messages are sent
    /// first, within `timing::close_flush_max`, even if the channel is destroyed meanwhile. Without
    /// a flush, destroying the channel closes it at once.
    virtual void close(bool flush = false) = 0;
    [[nodiscard]] virtual bool is_open() const = 0;
    /// Returns when the connection has ended, that is after the flush of `close`.
    [[nodiscard]] virtual asio::awaitable<void> wait_until_closed() = 0;

    [[nodiscard]] virtual const Traffic& traffic() const = 0;
    /// The other end as HOST:PORT, for logs.
    [[nodiscard]] virtual const std::string& peer() const = 0;
    /// The other end's address, without the port.
    [[nodiscard]] virtual const std::string& peer_host() const = 0;
    /// This end's address, without the port.
    [[nodiscard]] virtual const std::string& own_host() const = 0;
    /// Whether both programs run on the same host: they have the same address and, by their
    /// greetings, the same boot id. The address alone would be wrong for a tunnel that ends here.
    [[nodiscard]] bool is_within_host() const { return is_within_host_; }
    /// Takes the boot id of the peer's greeting.
    void set_peer_boot_id(std::uint64_t id) {
        is_within_host_ = id != 0 && id == boot_id() && peer_host() == own_host();
    }
    // The next three are those of `Stream`; by default, of a plain one.
    [[nodiscard]] virtual bool is_secured() const { return false; }
    [[nodiscard]] virtual std::optional<Identity> peer_identity() const { return std::nullopt; }
    [[nodiscard]] virtual std::optional<Sha256> binding() const { return std::nullopt; }

  private:
    bool is_within_host_ = false;
};

/// The endpoint, security and role of a peer to connect to.
struct Target {
    Target(Endpoint there, // Enough by itself for plain TCP.
           std::shared_ptr<const Tls> secured_by = nullptr,
           CertifiedRole expected = CertifiedRole::Master)
        : endpoint(std::move(there)), tls(std::move(secured_by)), role(expected) {}

    Endpoint endpoint;
    std::shared_ptr<const Tls> tls; ///< Null: plain TCP.
    CertifiedRole role;             ///< The role that the peer's certificate must name.
};

/// Connects; each step must finish within the timeout. Errors: Disconnected naming host and port;
/// Refused if one end rejects the other's certificate, or the peer has another role.
[[nodiscard]] asio::awaitable<Result<std::shared_ptr<Channel>>>
connect(Target target, std::chrono::seconds timeout = timing::connect_timeout);

/// Checks that the endpoint accepts TCP connections, with any protocol. Errors: Disconnected naming
/// host and port.
[[nodiscard]] asio::awaitable<Status> reach(Endpoint endpoint, std::chrono::seconds timeout);

/// Wraps an accepted socket in a channel, after a TLS handshake unless `tls` is null, within the
/// timeout. A peer that uses TLS when `tls` is null, or plain TCP otherwise, gets an error in its
/// own protocol. Errors: those of `Stream::secure`.
[[nodiscard]] asio::awaitable<Result<std::shared_ptr<Channel>>>
accept_channel(asio::ip::tcp::socket socket,
               std::shared_ptr<const Tls> tls,
               std::chrono::steady_clock::duration timeout = timing::connect_timeout);

/// Sends a Hello and awaits the answer within the timeout. The channel then expects the messages of
/// the requested role. Errors: Refused with the peer's reason, and those of `receive`.
[[nodiscard]] asio::awaitable<Result<Welcome>>
greet(std::shared_ptr<Channel> channel,
      Hello hello,
      std::chrono::steady_clock::duration timeout = timing::connect_timeout);

/// Checks that the peer has this end's protocol version. Errors: Refused naming both versions.
[[nodiscard]] Status check_version(const Hello& hello);

/// Awaits the Hello of an accepted peer within `timing::connect_timeout`. The channel then expects
/// messages of the Hello's role, and the caller answers with a Welcome. After a wrong version or
/// message, sends a Failure and closes. Errors: Refused, BadFrame, and those of `receive`.
[[nodiscard]] asio::awaitable<Result<Hello>> accept_hello(std::shared_ptr<Channel> channel);

/// Runs a detached coroutine. Logs an exception that escapes from it under `name`.
void spawn(asio::any_io_executor executor, std::string name, asio::awaitable<void> coroutine);

} // namespace cd
