// Proves that a peer that stops reading is given up in time, whatever operation waits for it, and
// that a merely slow one is not.
#include "proto/channel/channel.hpp"
#include "tests/proto/loopback.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t piece_bytes = 1u << 20;

/// One end sends; only the test reads from the other.
struct OneWay {
    std::shared_ptr<Channel> sender;
    asio::ip::tcp::socket reader;

    void send_pieces(std::size_t count) const {
        Results results;
        results.records.resize(piece_bytes);
        for (std::size_t i = 0; i < count; ++i) {
            sender->send(results);
        }
    }
};

/// Small buffers keep reading and writing in step.
asio::awaitable<OneWay> connect_one_way(StallBounds stalls) {
    SocketEnds ends = co_await connect_sockets();
    ends.left.set_option(asio::socket_base::receive_buffer_size(128 << 10));
    ends.right.set_option(asio::socket_base::send_buffer_size(128 << 10));
    auto stream = std::make_unique<Stream>(std::move(ends.right));
    co_return OneWay{Channel::make(std::move(stream), stalls), std::move(ends.left)};
}

asio::awaitable<void> await_room(std::shared_ptr<Channel> channel, bool& has_ended) {
    co_await channel->wait_until_queued_below(1);
    has_ended = true;
}

CD_CONVERSATION(WriteStall, APeerThatReadsNothingIsGivenUp) {
    const auto executor = co_await asio::this_coro::executor;
    const OneWay link = co_await connect_one_way({.write = 50ms});
    link.send_pieces(16);
    bool has_ended = false;
    spawn(executor, "waits for room", await_room(link.sender, has_ended));
    const Result<Message> message = co_await link.sender->receive(patience);
    EXPECT_EQ(message.error().code, ErrorCode::Disconnected);
    EXPECT_THAT(message.error().detail, testing::HasSubstr("does not read"));
    EXPECT_FALSE(link.sender->is_open());
    EXPECT_EQ(link.sender->queued_bytes(), 0u);
    co_await link.sender->wait_until_closed();
    co_await asio::post(executor, asio::use_awaitable);
    EXPECT_TRUE(has_ended);
}

CD_CONVERSATION(WriteStall, ASlowReaderIsServedAsLongAsEachFrameIsTaken) {
    constexpr auto stall_max = 2s;
    const auto executor = co_await asio::this_coro::executor;
    OneWay link = co_await connect_one_way({.write = stall_max});
    const auto end = Clock::now() + 2 * stall_max;
    asio::steady_timer pause(executor);
    Bytes bytes(piece_bytes);
    while (Clock::now() < end && link.sender->is_open()) {
        link.send_pieces(link.sender->queued_bytes() < 4 * piece_bytes ? 4 : 0);
        co_await asio::async_read(link.reader, asio::buffer(bytes), asio::use_awaitable);
        pause.expires_after(100ms);
        co_await pause.async_wait(asio::use_awaitable);
    }
    EXPECT_TRUE(link.sender->is_open());
    EXPECT_GT(link.sender->queued_bytes(), 0u) << "it was never slow";
    link.sender->close();
}

} // namespace
} // namespace cd::tests
