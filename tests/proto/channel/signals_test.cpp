// Proves that signals are counted, and that they end a process that no longer handles them.
#include "proto/channel/signals.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <vector>

namespace cd::tests {
namespace {

bool ends_the_process(int signal) {
    struct sigaction now {};
    EXPECT_EQ(sigaction(signal, nullptr, &now), 0);
    return now.sa_handler == SIG_DFL;
}

TEST(StopSignals, AreCounted) {
    asio::io_context context;
    std::vector<unsigned> counts;
    StopSignals signals(context.get_executor(), [&](unsigned count) {
        counts.push_back(count);
        if (count == 1) {
            std::raise(SIGINT);
        } else {
            signals.cancel();
        }
    });
    std::raise(SIGTERM);
    context.run();
    EXPECT_EQ(counts, (std::vector<unsigned>{1, 2}));
}

TEST(StopSignals, EndTheProcessOnceNobodyListens) {
    asio::io_context context;
    StopSignals signals(context.get_executor(), [](unsigned) {});
    ASSERT_FALSE(ends_the_process(SIGTERM));
    signals.cancel();
    EXPECT_TRUE(ends_the_process(SIGTERM));
    EXPECT_TRUE(ends_the_process(SIGINT));
}

} // namespace
} // namespace cd::tests
