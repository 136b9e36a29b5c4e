// Proves what workers miss for scenarios and ranges, and what that is taken to cost.
#include "common/core/timing/master.hpp"
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(BlockNeeds, AScenarioFetchesWhatItsWorkerDoesNotHold) {
    DispatchStage stage;
    DispatchJob& job = stage.open("earliest-finish");
    WorkerProxy& one = stage.join(1);
    DispatchScenario first = DispatchStage::scenario(job, {0, 1});
    MissingBlocks missing = stage.blocks.hold(job, first, one);
    EXPECT_TRUE(first.fetches);
    missing.hint(one, job, stage.actions);
    ASSERT_EQ(stage.actions.size(), 2u);
    EXPECT_EQ(std::get<SendHint>(stage.actions[0]).roots, (std::vector<RootIndex>{0, 1}));
    EXPECT_EQ(std::get<SendHint>(stage.actions[1]).tree, job.trees.of(1).tree);
    EXPECT_DOUBLE_EQ(one.transfers_end(),
                     (2 * 6400 + 64) / limits::link_bytes_per_second_start +
                         3 * timing::block_seconds);
    DispatchScenario again = DispatchStage::scenario(job, {1});
    EXPECT_TRUE(stage.blocks.hold(job, again, one).is_nothing());
    EXPECT_FALSE(again.fetches);
}

TEST(BlockNeeds, FillingACacheCostsTheBlocksThatItLacks) {
    DispatchStage stage;
    DispatchJob& job = stage.open("earliest-finish");
    WorkerProxy& one = stage.join(1);
    const double all = stage.blocks.costs_of(job).all;
    EXPECT_DOUBLE_EQ(
        all, (4 * 6400 + 64) / limits::link_bytes_per_second_start + 5 * timing::block_seconds);
    stage.blocks.hold_roots(DispatchStage::scenario(job, {0, 1}).roots, one);
    EXPECT_DOUBLE_EQ(stage.blocks.costs_of(job).all, all * 2 / 5);
    EXPECT_TRUE(stage.blocks.costs_of(job).all_fits);
    stage.join(2, {"w", 1, 1, 400 * limits::wide_bytes_per_triangle});
    EXPECT_FALSE(stage.blocks.costs_of(job).all_fits);
}

TEST(BlockNeeds, BlocksThatARangeWantsCountForJobsWithTasksAtTheWorker) {
    DispatchStage stage;
    DispatchJob& job = stage.open("earliest-finish");
    DispatchJob& other = stage.open("earliest-finish", 2, 2);
    WorkerProxy& one = stage.join(1);
    stage.tasks.send_range(one, job, {{0, 4}}, 100, stage.actions);
    stage.blocks.hold_wanted(stage.queue, one, job.trees.of(0).tree, std::vector<RootIndex>{3});
    job.missing.ranges_answered(1);
    other.missing.ranges_answered(1);
    EXPECT_DOUBLE_EQ(job.missing.any_or(0),
                     6400 / limits::link_bytes_per_second_start + timing::block_seconds);
    EXPECT_EQ(other.missing.any_or(0), 0);
}

} // namespace
} // namespace cd::tests
