// Proves that work runs on the pool that is asked for, and that its outcome is taken up on the
// owner's thread, which is told of each.
#include "master/base/background.hpp"

#include <gtest/gtest.h>

#include <latch>
#include <string>
#include <thread>

namespace cd::tests {
namespace {

class BackgroundTest : public testing::Test {
  protected:
    void run() {
        const auto work = asio::make_work_guard(context_);
        while (log_.find("after") == std::string::npos) {
            context_.run_one();
        }
    }

    asio::io_context context_;
    AsioLoop loop_{context_.get_executor()};
    ThreadPool compute_{1};
    ThreadPool blocking_{1};
    std::string log_;
    Background background_{loop_, compute_, blocking_, [this] { log_ += "after"; }};
    const std::thread::id owner_ = std::this_thread::get_id();
};

TEST_F(BackgroundTest, AnOutcomeIsTakenUpOnTheOwnersThread) {
    background_.compute([] { return std::this_thread::get_id(); },
                        [this](std::thread::id worked_on) {
                            EXPECT_NE(worked_on, owner_);
                            EXPECT_EQ(std::this_thread::get_id(), owner_);
                            log_ += "done ";
                        });
    EXPECT_EQ(log_, "") << "not within the call";
    run();
    EXPECT_EQ(log_, "done after");
}

TEST_F(BackgroundTest, AFunctionPostedFromAPoolRunsOnTheOwnersThread) {
    compute_.post([this] {
        background_.post([this] {
            EXPECT_EQ(std::this_thread::get_id(), owner_);
            log_ += "posted ";
        });
    });
    run();
    EXPECT_EQ(log_, "posted after");
}

TEST_F(BackgroundTest, BlockingWorkDoesNotWaitForTheComputePool) {
    const auto released = std::make_shared<std::latch>(1);
    compute_.post([released] { released->wait(); });
    background_.block([] { return 7; }, [this](int value) { log_ += std::to_string(value) + " "; });
    run();
    EXPECT_EQ(log_, "7 after");
    released->count_down();
}

TEST_F(BackgroundTest, WorkIsFreedOnTheOwnersThread) {
    std::thread::id freed_on;
    const auto note = [&](int* value) {
        freed_on = std::this_thread::get_id();
        delete value;
    };
    background_.compute([held = std::shared_ptr<int>(new int(7), note)] { return *held; },
                        [](int /*value*/) {});
    run();
    EXPECT_EQ(freed_on, owner_);
}

} // namespace
} // namespace cd::tests
