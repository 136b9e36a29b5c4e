// Proves what a job learns while it runs.
#include "master/dispatch/job/job_meters.hpp"

#include "common/core/limits/master.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(RangePace, IsTheWorkersElseThatOfAllElseTheGuess) {
    RangePace pace;
    EXPECT_EQ(pace.per_thread(WorkerId{1}, 7), 7);
    pace.add(WorkerId{1}, 20, 2);
    EXPECT_DOUBLE_EQ(pace.per_thread(WorkerId{1}, 7), 10);
    EXPECT_DOUBLE_EQ(pace.per_thread(WorkerId{2}, 7), 10);
    pace.add(WorkerId{2}, 10, 10);
    pace.forget(WorkerId{1});
    EXPECT_DOUBLE_EQ(pace.per_thread(WorkerId{2}, 7), 1);
    EXPECT_DOUBLE_EQ(pace.per_thread(WorkerId{1}, 7), (0.9 * 20 + 10) / (0.9 * 2 + 10));
}

TEST(MissingMeter, AveragesTheMatchedScenariosBetweenTwoSamples) {
    MissingMeter meter;
    MissingCosts costs;
    EXPECT_TRUE(meter.is_sampled());
    meter.add_sample(4);
    for (int i = 0; i < 16; ++i) {
        meter.add_matched(2);
        EXPECT_EQ(meter.is_sampled(), i == 15);
    }
    meter.tell(costs);
    EXPECT_FALSE(costs.matched || costs.any);
    meter.add_sample(4);
    meter.tell(costs);
    EXPECT_EQ(costs.matched, 2);
    EXPECT_EQ(costs.any, 4);
}

TEST(MissingMeter, ScenariosThatMissNothingCount) {
    MissingMeter meter;
    MissingCosts costs;
    for (int i = 0; i < 17; ++i) {
        if (meter.is_sampled()) {
            meter.add_sample(0);
        }
    }
    meter.tell(costs);
    EXPECT_EQ(costs.matched, 0);
    EXPECT_EQ(costs.any, 0);
}

TEST(MissingMeter, LearnsFromRangesWhatAnyWorkerMisses) {
    MissingMeter meter;
    EXPECT_EQ(meter.any_or(1), 1);
    meter.add_in_ranges(3);
    meter.add_in_ranges(3);
    meter.ranges_answered(2);
    EXPECT_EQ(meter.any_or(1), 3);
}

TEST(CopyBudget, IsAShareOfTheWorkThatStands) {
    CopyBudget budget;
    budget.add_work(2000);
    budget.remove_work(1000);
    EXPECT_EQ(budget.left_ns(), static_cast<std::uint64_t>(1000 * limits::copies_share_max));
    budget.add_copy(30);
    EXPECT_EQ(budget.left_ns(), 20u);
    budget.remove_work(5000);
    EXPECT_EQ(budget.left_ns(), 0u);
}

} // namespace
} // namespace cd::tests
