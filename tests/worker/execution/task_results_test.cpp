// Proves that a task's results are summed until they are taken, each once.
#include "worker/execution/task_results.hpp"

#include "common/job/result/packed_records.hpp"

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
    EXPECT_FALSE(results.take(TaskId{1}, job, false));
    EXPECT_EQ(results.seconds_per_scenario(), 0.0);
    results.add(finished(2, 4));
    results.add(finished(1, 1));
    results.add(finished(0, 0));
    EXPECT_EQ(results.seconds_per_scenario(), 1.0) << "of the last that has scenarios";
    EXPECT_GE(results.bytes(), 30u);
    const auto taken = results.take(TaskId{1}, job, false);
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->task, TaskId{1});
    EXPECT_EQ(taken->job, job.id);
    EXPECT_EQ(taken->count, 3u);
    EXPECT_EQ(taken->compute_seconds, 5.0);
    EXPECT_EQ(results.bytes(), 0u);
    EXPECT_FALSE(results.take(TaskId{1}, job, false)) << "they are taken";
}

TEST(TaskResults, ArePackedUnlessTheMasterRunsOnThisHost) {
    const WorkerJob job;
    for (const bool is_within_host : {false, true}) {
        TaskResults results;
        results.add(finished(3, 1));
        const auto taken = results.take(TaskId{1}, job, is_within_host);
        ASSERT_TRUE(taken);
        EXPECT_EQ(taken->are_packed, !is_within_host);
        Bytes unpacked;
        const auto records = received_records(taken->records, taken->are_packed, unpacked);
        EXPECT_EQ(records.value().size(), 3 * (sizeof(std::uint32_t) + 10));
    }
}

} // namespace
} // namespace cd::tests
