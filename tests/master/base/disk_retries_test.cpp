// Proves that a waiting step runs exactly once: in its time, or when its job ends.
#include "master/base/disk_retries.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

class DiskRetriesTest : public testing::Test {
  protected:
    asio::io_context context_;
    AsioLoop loop_{context_.get_executor()};
    DiskRetries retries_{loop_};
    int runs_ = 0;
};

TEST_F(DiskRetriesTest, EachStepRunsOnceAfterAWhile) {
    retries_.start(JobId{1}, [this] { ++runs_; });
    retries_.start(JobId{1}, [this] { ++runs_; });
    retries_.start(JobId{2}, [this] { ++runs_; });
    context_.poll();
    EXPECT_EQ(runs_, 0);
    EXPECT_TRUE(retries_.any(JobId{1}));
    context_.run();
    EXPECT_EQ(runs_, 3);
    EXPECT_FALSE(retries_.any(JobId{1}));
    EXPECT_FALSE(retries_.any(JobId{2}));
}

TEST_F(DiskRetriesTest, StepsOfAnEndedJobRunSoon) {
    retries_.start(JobId{1}, [this] { ++runs_; });
    retries_.start(JobId{2}, [this] { runs_ += 10; });
    retries_.stop(JobId{1});
    EXPECT_FALSE(retries_.any(JobId{1}));
    EXPECT_EQ(runs_, 0) << "not within stop";
    context_.poll();
    EXPECT_EQ(runs_, 1);
    context_.run();
    EXPECT_EQ(runs_, 11);
}

TEST_F(DiskRetriesTest, AfterTheCloseNothingRuns) {
    retries_.start(JobId{1}, [this] { ++runs_; });
    retries_.close();
    EXPECT_FALSE(retries_.any(JobId{1}));
    context_.run();
    EXPECT_EQ(runs_, 0);
}

TEST_F(DiskRetriesTest, AStepMayStartTheNext) {
    retries_.start(JobId{1}, [this] {
        EXPECT_FALSE(retries_.any(JobId{1}));
        retries_.start(JobId{1}, [this] { ++runs_; });
    });
    context_.run();
    EXPECT_EQ(runs_, 1);
}

} // namespace
} // namespace cd::tests
