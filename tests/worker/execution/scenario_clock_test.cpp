// Proves that the longest-running scenario is found among those that run.
#include "worker/execution/scenario_clock.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(RunningClocks, NameTheScenarioThatHasRunForTheLongestTime) {
    RunningClocks clocks;
    auto first = clocks.add(JobId{1});
    const auto second = clocks.add(JobId{2});
    EXPECT_FALSE(clocks.longest()) << "nothing runs";
    first->begin(7);
    second->begin(8);
    ASSERT_TRUE(clocks.longest());
    EXPECT_EQ(clocks.longest()->scenario, 7u);
    EXPECT_EQ(clocks.longest()->job, JobId{1});
    EXPECT_GE(clocks.longest()->seconds, 0.0);
    first.reset(); // Its thread has ended the job.
    EXPECT_EQ(clocks.longest()->scenario, 8u);
    second->end();
    EXPECT_FALSE(clocks.longest());
}

} // namespace
} // namespace cd::tests
