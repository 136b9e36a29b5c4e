// A connection that carries messages, over TCP or TLS.
#pragma once

#include "common/core/limits/wire.hpp"
#include "common/core/result.hpp"
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

/// Errors: BadInput saying what is expected.
[[nodiscard]] Result<Endpoint> parse_endpoint(const std::string& text);
/// True for 127.0.0.0/8, ::1 and "localhost".
[[nodiscard]] bool is_loopback(const Endpoint& endpoint);

/// How a program is about to use an endpoint.
struct Exposure {
    bool secured = false;  ///< By TLS.
    bool insecure = false; ///< --insecure was given.
    bool listening = false;
};
/// Without TLS nothing leaves or enters beyond loopback unless `insecure` says so. Errors: Refused
/// saying how TLS is had, and naming the option; with `insecure` a warning is logged, whatever the
/// level.
[[nodiscard]] Status check_exposure(const Endpoint& endpoint, const Exposure& exposure);

/// Counts of one connection.
struct Traffic {
    std::uint64_t bytes_sent = 0;
    std::uint64_t bytes_received = 0;
};

/// How long a frame may take. Then the channel closes.
struct StallBounds {
    /// The next one of a message that has begun to come.
    std::chrono::steady_clock::duration read = limits::read_stall_max;
    /// One that is sent, until the operating system has taken it.
    std::chrono::steady_clock::duration write = limits::write_stall_max;
};

/// One peer. All members run on the executor of the socket, on one thread. Control messages go
/// before data messages; a data message goes in frames, so that a heartbeat waits for one at most.
class Channel : public std::enable_shared_from_this<Channel> {
  public:
    /// The stream is connected, and secured if it is to be.
    [[nodiscard]] static std::shared_ptr<Channel> make(std::unique_ptr<Stream> stream,
                                                       const StallBounds& stalls = {});

    /// The next message. Nothing is read from the socket beyond one message that nobody awaits, so
    /// a slow caller slows the peer. Errors: Timeout when `timeout` passes without one (the channel
    /// stays usable); Disconnected, also when a frame stands still; Refused, by a peer that does
    /// not take this end's certificate; BadFrame or TooLarge for bytes that are none, or are not
    /// for the other end to send, after which the channel is closed. The first message must be a
    /// Hello, Welcome or Failure, and small. One caller at a time.
    [[nodiscard]] asio::awaitable<Result<Message>>
    receive(std::chrono::steady_clock::duration timeout);

    /// What the other end is, past its greeting: by that goes what it may send, and memory for it.
    void expect(Party party);

    /// Queues the message, which must not be over its type's limit (`payload_bytes_max`). Never
    /// blocks; after `close` it does nothing. Who sends much awaits `wait_until_queued_below`.
    void send(const Message& message);

    /// Not yet handed to the operating system.
    [[nodiscard]] std::size_t queued_bytes() const;
    /// Returns when less than `bytes` are queued, or the channel is closed.
    [[nodiscard]] asio::awaitable<void> wait_until_queued_below(std::size_t bytes);

    /// Ends the connection; a waiting `receive` fails. With `flush`, what is queued goes out first,
    /// within `limits::close_flush_max`, also after the last owner has dropped the channel; without
    /// it, dropping the channel closes it at once.
    void close(bool flush = false);
    [[nodiscard]] bool is_open() const;
    /// Returns when the connection has ended, which a `close` with `flush` does not do at once.
    [[nodiscard]] asio::awaitable<void> wait_until_closed();

    [[nodiscard]] const Traffic& traffic() const;
    /// The other end's address, for logs.
    [[nodiscard]] const std::string& peer() const;
    /// The addresses of both ends, without their ports.
    [[nodiscard]] const std::string& peer_host() const;
    [[nodiscard]] const std::string& own_host() const;
    /// Those of its stream.
    [[nodiscard]] bool is_secured() const;
    [[nodiscard]] const std::optional<Identity>& peer_identity() const;
    [[nodiscard]] std::optional<Sha256> binding() const;

  private:
    struct State;
    explicit Channel(std::shared_ptr<State> state);
    std::shared_ptr<State> state_; ///< Operations under way share it.

  public:
    Channel(const Channel&) = delete;
    Channel& operator=(const Channel&) = delete;
    ~Channel();
};

/// Whom a connection is made to.
struct Target {
    Target(Endpoint there, // Where plain TCP is meant, the endpoint says it all.
           std::shared_ptr<const Tls> secured_by = nullptr,
           CertifiedRole expected = CertifiedRole::Master)
        : endpoint(std::move(there)), tls(std::move(secured_by)), role(expected) {}

    Endpoint endpoint;
    std::shared_ptr<const Tls> tls; ///< Null: plain.
    CertifiedRole role;
};

/// Connects, each step within the timeout. Errors: Disconnected naming host and port; Refused when
/// one end does not take the other's certificate, or the other end is of another role.
[[nodiscard]] asio::awaitable<Result<std::shared_ptr<Channel>>>
connect(Target target, std::chrono::seconds timeout = limits::connect_timeout);

/// Somebody takes connections there, whatever they speak. Errors: Disconnected naming host and
/// port.
[[nodiscard]] asio::awaitable<Status> reach(Endpoint endpoint, std::chrono::seconds timeout);

/// What follows when a socket was accepted, within the timeout. A peer that speaks TLS where `tls`
/// is null, or does not where it is there, is told so in its own terms. Errors: those of
/// `Stream::secure`.
[[nodiscard]] asio::awaitable<Result<std::shared_ptr<Channel>>>
accept_channel(asio::ip::tcp::socket socket,
               std::shared_ptr<const Tls> tls,
               std::chrono::steady_clock::duration timeout = limits::connect_timeout);

/// Says hello and awaits the answer within the timeout; a channel then expects what the role asked
/// for. Errors: Refused with the other side's
/// reason, and those of `receive`.
[[nodiscard]] asio::awaitable<Result<Welcome>>
greet(std::shared_ptr<Channel> channel,
      Hello hello,
      std::chrono::steady_clock::duration timeout = limits::connect_timeout);

/// Errors: Refused naming the versions of both sides, where they differ.
[[nodiscard]] Status check_version(const Hello& hello);

/// Awaits the hello of whoever connected, within `limits::connect_timeout`. A peer of another
/// version, or that says something else, is told so and the channel closed; else it expects what
/// the role sends. The caller answers with a Welcome. Errors: Refused, BadFrame, and those of
/// `receive`.
[[nodiscard]] asio::awaitable<Result<Hello>> accept_hello(std::shared_ptr<Channel> channel);

/// Runs a coroutine on its own; what escapes from it is logged under `name`.
void spawn(asio::any_io_executor executor, std::string name, asio::awaitable<void> coroutine);

} // namespace cd
