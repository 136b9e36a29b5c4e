// Delays the bytes of one direction of a connection, and keeps their order.
#pragma once

#include "proto/channel/asio.hpp"

#include <chrono>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>

namespace cd::tests {

/// A first-in-first-out line of pieces of bytes. As on a long cable, many pieces are under way at
/// once: the delay does not limit the rate. Used on one thread, by one coroutine at each end.
class DelayLine {
  public:
    explicit DelayLine(const asio::any_io_executor& executor)
        : has_room_(executor, Clock::time_point::max()),
          has_piece_(executor, Clock::time_point::max()) {}

    /// Puts a piece in, which arrives `delay` later. Waits before while more than `limit` bytes are
    /// under way. Drops the piece if the line is closed.
    asio::awaitable<void>
    put(std::string piece, std::chrono::milliseconds delay, std::size_t limit);
    /// Waits for the arrival of the next piece; empty if none is left and the line is closed.
    asio::awaitable<std::optional<std::string>> take();
    /// Ends the line; pieces that are under way still arrive.
    void close();

    [[nodiscard]] std::size_t bytes_under_way() const { return bytes_; }

  private:
    using Clock = std::chrono::steady_clock;
    struct Piece {
        Clock::time_point arrival;
        std::string bytes;
    };

    std::deque<Piece> pieces_;
    std::size_t bytes_ = 0;
    bool is_closed_ = false;
    asio::steady_timer has_room_;  ///< Cancelled when a piece leaves.
    asio::steady_timer has_piece_; ///< Cancelled when a piece comes, and at the end.
};

} // namespace cd::tests
