#include "tests/cluster/delay_line.hpp"

#include <utility>

namespace cd::tests {

namespace {

asio::awaitable<void> wait(asio::steady_timer& timer) {
    boost::system::error_code ignored;
    co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
}

} // namespace

asio::awaitable<void>
DelayLine::put(std::string piece, std::chrono::milliseconds delay, std::size_t limit) {
    while (bytes_ > limit && !is_closed_) {
        co_await wait(has_room_);
    }
    if (!is_closed_) {
        bytes_ += piece.size();
        pieces_.push_back({Clock::now() + delay, std::move(piece)});
        has_piece_.cancel();
    }
}

asio::awaitable<std::optional<std::string>> DelayLine::take() {
    while (pieces_.empty()) {
        if (is_closed_) {
            co_return std::nullopt;
        }
        co_await wait(has_piece_);
    }
    if (pieces_.front().arrival > Clock::now()) {
        asio::steady_timer arrival(has_piece_.get_executor(), pieces_.front().arrival);
        co_await wait(arrival);
    }
    std::string piece = std::move(pieces_.front().bytes);
    pieces_.pop_front();
    bytes_ -= piece.size();
    has_room_.cancel();
    co_return piece;
}

void DelayLine::close() {
    is_closed_ = true;
    has_piece_.cancel();
    has_room_.cancel();
}

} // namespace cd::tests
