// A connection that carries messages, over TCP or TLS.
#pragma once

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
#include <optional>
#include <string>

namespace cd {

/// Byte counts of one connection.
struct Traffic {
    std::uint64_t bytes_sent = 0;
    std::uint64_t bytes_received = 0;
};

/// Time limits for frames. A channel closes when one is exceeded.
struct StallBounds {
    /// Longest wait for the next frame of a message that has begun to arrive.
    std::chrono::steady_clock::duration read = timing::read_stall_max;
    /// Longest time until the operating system accepts a frame.
    std::chrono::steady_clock::duration write = timing::write_stall_max;
};

/// A connection to one peer. All members run on the socket's executor, on one thread. Control
/// messages are sent before data messages. Messages are sent in frames, so that a heartbeat waits
/// for one frame at most.
class Channel {
  public:
    /// The stream must be connected, and secured if the channel uses TLS.
    [[nodiscard]] static std::shared_ptr<Channel> make(std::unique_ptr<Stream> stream,
                                                       const StallBounds& stalls = {});

    /// Receives the next message. Reads at most one message ahead, so that a slow caller slows the
    /// peer. Errors: Timeout (the channel stays usable); Disconnected, also for a stalled frame;
    /// Refused if the peer rejects this end's certificate; BadFrame or TooLarge for invalid bytes
    /// or a message that the peer may not send, which close the channel. The first message must be
    /// a small Hello, Welcome or Failure. One caller at a time.
    [[nodiscard]] asio::awaitable<Result<Message>>
    receive(std::chrono::steady_clock::duration timeout);

    /// Sets the peer's party after its greeting. The party decides which messages the peer may
    /// send, and how large.
    void expect(Party party);

    /// Queues a message, whose payload has at most the `payload_bytes_max` of its type. Never
    /// blocks; does nothing after `close`. Senders of much data await `wait_until_queued_below`.
    void send(const Message& message);

    /// Bytes not yet handed to the operating system.
    [[nodiscard]] std::size_t queued_bytes() const;
    /// Returns when fewer than `bytes` bytes are queued, or the channel is closed.
    [[nodiscard]] asio::awaitable<void> wait_until_queued_below(std::size_t bytes);

    /// Closes the connection; a waiting `receive` fails. With `flush`, queued messages are sent
    /// first, within `timing::close_flush_max`, even if the channel is destroyed meanwhile. Without
    /// a flush, destroying the channel closes it at once.
    void close(bool flush = false);
    [[nodiscard]] bool is_open() const;
    /// Returns when the connection has ended, that is after the flush of `close`.
    [[nodiscard]] asio::awaitable<void> wait_until_closed();

    [[nodiscard]] const Traffic& traffic() const;
    /// The other end as HOST:PORT, for logs.
    [[nodiscard]] const std::string& peer() const;
    /// The other end's address, without the port.
    [[nodiscard]] const std::string& peer_host() const;
    /// This end's address, without the port.
    [[nodiscard]] const std::string& own_host() const;
    // `is_secured`, `peer_identity` and `binding` forward to `Stream`.
    [[nodiscard]] bool is_secured() const;
    [[nodiscard]] const std::optional<Identity>& peer_identity() const;
    [[nodiscard]] std::optional<Sha256> binding() const;

  private:
    struct State;
    explicit Channel(std::shared_ptr<State> state);
    std::shared_ptr<State> state_; ///< Shared with pending operations.

  public:
    Channel(const Channel&) = delete;
    Channel& operator=(const Channel&) = delete;
    ~Channel();
};

} // namespace cd
