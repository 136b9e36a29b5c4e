// Proves that a task's results are summed until they are taken, each once.
#include "worker/execution/task_results.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

FinishedScenarios finished(std::uint32_t count, double seconds) {
    FinishedScenarios one;
    for (std::uint32_t i = 0; i < count; ++i) {
        one.add(Bytes(10));
    }
    one.seconds = seconds;
    return one;
}

TEST(TaskResults, AreSummedUntilTheyAreTaken) {
    WorkerJob job;
    job.id = JobId{3};
    TaskResults results;
    EXPECT_FALSE(results.take(TaskId{1}, job));
    EXPECT_EQ(results.seconds_per_scenario(), 0.0);
    results.add(finished(2, 4));
    results.add(finished(1, 1));
    results.add(finished(0, 0));
    EXPECT_EQ(results.seconds_per_scenario(), 1.0) << "of the last that has scenarios";
    EXPECT_GE(results.bytes(), 30u);
    const auto taken = results.take(TaskId{1}, job);
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->task, TaskId{1});
    EXPECT_EQ(taken->job, job.id);
    EXPECT_EQ(taken->count, 3u);
    EXPECT_EQ(taken->compute_seconds, 5.0);
    EXPECT_EQ(results.bytes(), 0u);
    EXPECT_FALSE(results.take(TaskId{1}, job)) << "they are taken";
}

} // namespace
} // namespace cd::tests
