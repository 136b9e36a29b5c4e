// Proves that functions run after their delays, and that no delayed function runs after the close.
#include "master/base/event_loop.hpp"

#include <gtest/gtest.h>

#include <string>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

class EventLoopTest : public testing::Test {
  protected:
    void add(std::chrono::hours delay, const std::string& name) {
        loop_.after(delay, [this, name] { log_ += name; });
    }

    asio::io_context context_;
    AsioLoop loop_{context_.get_executor()};
    std::string log_;
};

TEST_F(EventLoopTest, AFunctionRunsAfterItsDelay) {
    add(24h, "later");
    add(0h, "soon");
    EXPECT_EQ(log_, "") << "not within the call";
    context_.run_one();
    EXPECT_EQ(log_, "soon");
}

TEST_F(EventLoopTest, AFunctionMayStartTheNext) {
    loop_.after(0h, [this] { add(0h, "next"); });
    context_.run();
    EXPECT_EQ(log_, "next");
}

TEST_F(EventLoopTest, TheCloseDropsDelayedFunctions) {
    add(0h, "expired");
    add(24h, "running");
    loop_.close();
    add(0h, "late");
    context_.run(); // Returns, because no timer is left.
    EXPECT_EQ(log_, "");
}

TEST_F(EventLoopTest, AFunctionMayDropTheOthers) {
    loop_.after(0h, [this] { loop_.close(); });
    add(0h, "expired meanwhile");
    context_.run();
    EXPECT_EQ(log_, "");
}

} // namespace
} // namespace cd::tests
