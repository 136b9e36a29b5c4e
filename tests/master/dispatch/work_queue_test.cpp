// Proves what counts as unsent, in which order it waits, and when nothing is left.
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

#include <deque>

namespace cd::tests {
namespace {

using Queue = std::deque<std::uint64_t>;

DispatchScenario suspect_of(const DispatchJob& job) {
    DispatchScenario scenario = DispatchStage::scenario(job);
    for (std::uint32_t lost = 1; lost < limits::scenario_losses_max; ++lost) {
        scenario.losses.add(lost);
    }
    return scenario;
}

TEST(WorkQueue, AScenarioIsUnsentUntilItLeavesForATask) {
    DispatchStage stage;
    DispatchJob& job = stage.open("best-match");
    stage.add(job, 3);
    EXPECT_EQ(stage.queue.unsent(), 3u);
    job.waiting.pop_front(); // Into a buffer.
    stage.queue.put_back(job, std::vector<std::uint64_t>{0});
    EXPECT_EQ(job.waiting, (Queue{0, 1, 2}));
    EXPECT_EQ(stage.queue.unsent(), 3u);
    job.waiting.clear();
    stage.queue.leave(job, 3);
    stage.queue.put_back_sent(job, std::vector<std::uint64_t>{1, 2});
    EXPECT_EQ(job.waiting, (Queue{1, 2}));
    EXPECT_EQ(stage.queue.unsent(), 2u);
    stage.queue.remove(job, 1, job.at(1));
    EXPECT_EQ(job.waiting, Queue{2});
    EXPECT_EQ(stage.queue.unsent(), 1u);
}

TEST(WorkQueue, ASuspectWaitsApart) {
    DispatchStage stage;
    DispatchJob& job = stage.open("best-match");
    EXPECT_TRUE(stage.queue.add(job, 7, suspect_of(job)));
    EXPECT_TRUE(stage.queue.add(job, 8, suspect_of(job)));
    EXPECT_TRUE(job.waiting.empty());
    EXPECT_TRUE(stage.queue.something_waits());
    stage.queue.remove(job, 8, job.at(8));
    EXPECT_EQ(stage.queue.unsent(), 1u);
    EXPECT_EQ(stage.queue.take_suspect().position, 7u);
    EXPECT_EQ(stage.queue.unsent(), 1u);
    EXPECT_FALSE(stage.queue.something_waits());
}

TEST(WorkQueue, AClosedJobTakesItsScenariosAlong) {
    DispatchStage stage;
    DispatchJob& job = stage.open("best-match");
    stage.add(stage.open("best-match", 2, 2), 1);
    stage.add(job, 3);
    stage.queue.add(job, 77, suspect_of(job));
    stage.queue.close(job.id);
    EXPECT_EQ(stage.queue.unsent(), 1u);
    EXPECT_TRUE(stage.queue.suspects().empty());
    EXPECT_EQ(stage.queue.find(JobId{1}), nullptr);
    EXPECT_TRUE(stage.queue.is_tree_used(TreeId{1}));
    stage.queue.close(JobId{2});
    EXPECT_FALSE(stage.queue.is_tree_used(TreeId{1}));
}

TEST(WorkQueue, IsExhaustedOnceAllIsSentAndTheInputRests) {
    DispatchStage stage;
    DispatchJob& job = stage.open("best-match");
    EXPECT_TRUE(stage.queue.is_exhausted());
    EXPECT_TRUE(stage.queue.set_paused(false));
    EXPECT_FALSE(stage.queue.is_exhausted());
    EXPECT_FALSE(stage.queue.nothing_comes(job));
    stage.queue.set_paused(true);
    job.unsent.add({{0, 4}}, 3);
    EXPECT_FALSE(stage.queue.is_exhausted());
    job.unsent.take_all();
    EXPECT_FALSE(stage.queue.is_exhausted()); // Three scenarios follow.
    job.unsent.nothing_follows();
    EXPECT_TRUE(stage.queue.is_exhausted());
}

} // namespace
} // namespace cd::tests
