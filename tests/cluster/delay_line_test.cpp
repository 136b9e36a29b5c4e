#include "tests/cluster/delay_line.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cd::tests {

namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

/// Runs a coroutine to its end.
template <class Function>
void run_to_end(Function function) {
    asio::io_context context{1};
    asio::co_spawn(context, function(context), [](const std::exception_ptr& failed) {
        if (failed) {
            std::rethrow_exception(failed);
        }
    });
    context.run();
}

TEST(DelayLine, ManyPiecesAreUnderWayAtOnce) {
    run_to_end([](asio::io_context& context) -> asio::awaitable<void> {
        DelayLine line(context.get_executor());
        const auto begin = Clock::now();
        for (char i = 0; i < 50; ++i) {
            co_await line.put(std::string(1, i), milliseconds(40), 1000);
        }
        EXPECT_EQ(line.bytes_under_way(), 50u);
        for (char i = 0; i < 50; ++i) {
            EXPECT_EQ(co_await line.take(), std::string(1, i));
            EXPECT_GE(Clock::now() - begin, milliseconds(40));
        }
        EXPECT_EQ(line.bytes_under_way(), 0u);
    });
}

TEST(DelayLine, APieceDoesNotOvertakeASlowerOne) {
    run_to_end([](asio::io_context& context) -> asio::awaitable<void> {
        DelayLine line(context.get_executor());
        co_await line.put("slow", milliseconds(20), 1000);
        co_await line.put("fast", milliseconds(0), 1000);
        EXPECT_EQ(co_await line.take(), "slow");
        EXPECT_EQ(co_await line.take(), "fast");
    });
}

TEST(DelayLine, ASenderWaitsForRoom) {
    run_to_end([](asio::io_context& context) -> asio::awaitable<void> {
        DelayLine line(context.get_executor());
        co_await line.put("first", milliseconds(0), 0);
        bool is_put = false;
        asio::co_spawn(
            context,
            [&]() -> asio::awaitable<void> {
                co_await line.put("second", milliseconds(0), 0);
                is_put = true;
            },
            [](const std::exception_ptr&) {});
        co_await asio::post(context, asio::use_awaitable);
        EXPECT_FALSE(is_put);
        EXPECT_EQ(co_await line.take(), "first");
        EXPECT_EQ(co_await line.take(), "second");
        EXPECT_TRUE(is_put);
    });
}

TEST(DelayLine, WhatIsUnderWayArrivesAfterTheEnd) {
    run_to_end([](asio::io_context& context) -> asio::awaitable<void> {
        DelayLine line(context.get_executor());
        co_await line.put("last", milliseconds(10), 1000);
        line.close();
        co_await line.put("too late", milliseconds(0), 1000);
        EXPECT_EQ(co_await line.take(), "last");
        EXPECT_EQ(co_await line.take(), std::nullopt);
    });
}

} // namespace

} // namespace cd::tests
