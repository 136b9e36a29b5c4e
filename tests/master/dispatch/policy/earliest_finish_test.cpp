// Proves how `earliest-finish` chooses, and what it makes a batch of.
#include "master/dispatch/policy/earliest_finish.hpp"

#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

class EarliestFinishes : public testing::Test, protected DispatchStage {
  protected:
    void buffer(WorkerProxy& proxy, std::vector<std::uint64_t> costs_ns) {
        for (const std::uint64_t cost_ns : costs_ns) {
            queue.add(job_, next, scenario(job_, {0}, cost_ns));
            job_.waiting.clear();
            proxy.buffers.add(job_.id, next, job_.at(next).weight);
            ++next;
        }
    }

    DispatchJob& job_ = open("earliest-finish");
    const MatchingPolicy& policy_ = *job_.policy;
    WorkerProxy& one_ = join(1);
    WorkerProxy& two_ = join(2);
};

TEST_F(EarliestFinishes, AHolderIsAwaitedAsLongAsTheTransferWouldTake) {
    pace.add_transfer(one_, 6400, 0.1);
    const DispatchScenario wanted = scenario(job_);
    blocks.hold_roots(wanted.roots, two_);
    two_.tasks.note_answers(0, 0);
    for (const TreeRoots& side : wanted.roots) {
        plan.arrived(two_.slot(), side.tree, side.roots);
    }
    EXPECT_EQ(policy_.would_choose(job_, wanted), &two_);
    two_.buffers.add(job_.id, 77, {0, 90'000'000});
    EXPECT_EQ(policy_.would_choose(job_, wanted), &two_);
    two_.buffers.add(job_.id, 78, {0, 20'000'000});
    EXPECT_EQ(policy_.would_choose(job_, wanted), &one_);
    EXPECT_DOUBLE_EQ(policy_.finish_on(two_, job_, wanted).total(), 0.110 + 0.001);
}

TEST_F(EarliestFinishes, EqualsGoToTheFewestScenariosThenToTheSmallestId) {
    const DispatchScenario wanted = scenario(job_);
    EXPECT_EQ(policy_.would_choose(job_, wanted), &one_);
    one_.buffers.add(job_.id, 77, {0, 0});
    EXPECT_EQ(policy_.would_choose(job_, wanted), &two_);
    two_.set_silent(true);
    EXPECT_EQ(policy_.would_choose(job_, wanted), &one_);
    EXPECT_FALSE(policy_.may_take(two_, job_));
}

TEST_F(EarliestFinishes, ABatchIsTheHeadOfTheBufferUpToItsTime) {
    one_.batch.set(15, false);
    buffer(one_, {10, 10, 10});
    EXPECT_TRUE(policy_.is_full(one_, job_));
    EXPECT_EQ(policy_.take_batch(one_, job_), (std::vector<std::uint64_t>{0, 1}));
    EXPECT_FALSE(policy_.is_full(one_, job_));
    one_.batch.set(0, false);
    EXPECT_EQ(policy_.take_batch(one_, job_), std::vector<std::uint64_t>{2});
}

TEST_F(EarliestFinishes, TheLastLongScenariosGoLongestFirstToFreeThreads) {
    one_.batch.set(15, true);
    buffer(one_, {10, 30, 20});
    EXPECT_TRUE(policy_.has_room_for_task(one_, job_));
    tasks.send(one_, job_, policy_.take_batch(one_, job_), false, actions);
    EXPECT_EQ(last<SendUnit>().positions, (PositionRange{1, 1}));
    EXPECT_FALSE(policy_.has_room_for_task(one_, job_));
    queue.set_paused(false); // More may come.
    EXPECT_TRUE(policy_.has_room_for_task(one_, job_));
}

TEST_F(EarliestFinishes, EnoughIsFourBatchesForEachWorker) {
    pace.add_scenario(1'000'000);
    EXPECT_EQ(policy_.enough(job_), 2u * 4 * 100); // Of 0.1 s each.
}

} // namespace
} // namespace cd::tests
