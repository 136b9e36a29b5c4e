// Proves that functions run after their delays, and that none runs after the close.
#include "master/base/timers.hpp"

#include <gtest/gtest.h>

#include <string>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

class TimersTest : public testing::Test {
  protected:
    void add(std::chrono::hours delay, const std::string& name) {
        timers_.after(delay, [this, name] { log_ += name; });
    }

    asio::io_context context_;
    Timers timers_{context_.get_executor()};
    std::string log_;
};

TEST_F(TimersTest, AFunctionRunsAfterItsDelay) {
    add(24h, "later");
    add(0h, "soon");
    EXPECT_EQ(log_, "") << "not within the call";
    context_.run_one();
    EXPECT_EQ(log_, "soon");
}

TEST_F(TimersTest, AFunctionMayStartTheNext) {
    timers_.after(0h, [this] { add(0h, "next"); });
    context_.run();
    EXPECT_EQ(log_, "next");
}

TEST_F(TimersTest, TheCloseDropsAllFunctions) {
    add(0h, "expired");
    add(24h, "running");
    timers_.close();
    add(0h, "late");
    context_.run(); // Returns, because no timer is left.
    EXPECT_EQ(log_, "");
}

TEST_F(TimersTest, AFunctionMayDropTheOthers) {
    timers_.after(0h, [this] { timers_.close(); });
    add(0h, "expired meanwhile");
    context_.run();
    EXPECT_EQ(log_, "");
}

} // namespace
} // namespace cd::tests
