// Proves how scenarios move through buffers into tasks: jobs in turn, full buffers at once, others
// when nothing more comes.
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

class Allocating : public testing::Test, protected DispatchStage {
  protected:
    [[nodiscard]] std::vector<std::vector<std::uint64_t>> sent() const {
        std::vector<std::vector<std::uint64_t>> lists;
        for (const Action& action : actions) {
            lists.push_back(std::get<SendUnit>(action).positions.list());
        }
        return lists;
    }
};

using Lists = std::vector<std::vector<std::uint64_t>>;

TEST_F(Allocating, AFullBufferGoesAtOnceAndTheRestOnceTheInputRests) {
    DispatchJob& job = open("best-match", 2);
    WorkerProxy& one = join(1);
    queue.set_paused(false);
    add(job, 3);
    allocator.settle(actions);
    EXPECT_EQ(sent(), (Lists{{0, 1}}));
    EXPECT_EQ(one.buffers.count(), 1u);
    queue.set_paused(true);
    EXPECT_FALSE(filler.is_ripe(one, job)); // The worker has q scenarios.
    one.tasks.remove(last<SendUnit>().task, PositionRange{0, 1}, 1'000'000);
    EXPECT_TRUE(filler.is_ripe(one, job));
    filler.fill(one, actions);
    EXPECT_EQ(sent(), (Lists{{0, 1}, {2}}));
}

TEST_F(Allocating, ABatchIsNotShorterThanARoundTripToItsWorker) {
    DispatchJob& job = open("earliest-finish");
    WorkerProxy& near = join(1);
    WorkerProxy& far = join(2);
    TaskInFlight ended; // Sent at 0 s to an idle worker.
    ended.busy_seconds = 0.001;
    far.batch.judge(ended, false, 1, 0.061);
    ended.busy_seconds = 0.06;
    near.batch.judge(ended, false, 1, 0.061);
    add(job, 2);
    queue.set_paused(false);
    allocator.settle(actions);
    ASSERT_GT(near.buffers.count() + far.buffers.count(), 0u);
    allocator.settle(actions); // The share of what is buffered is short.
    const auto second_ns = 1e9 * pace.power_of(far);
    EXPECT_NEAR(static_cast<double>(far.batch.cost_ns()), 0.06 * second_ns, 1e-6 * second_ns);
    EXPECT_LT(static_cast<double>(near.batch.cost_ns()), 0.03 * second_ns);
}

TEST_F(Allocating, AllJobsAreServed) {
    DispatchJob& first = open("best-match", 4, 1);
    DispatchJob& second = open("best-match", 4, 2);
    WorkerProxy& one = join(1);
    WorkerProxy& two = join(2);
    queue.set_paused(false);
    add(first, 2);
    add(second, 2);
    allocator.settle(actions);
    EXPECT_EQ(one.buffers.count() + two.buffers.count(), 4u);
    EXPECT_EQ(one.buffers.of(first.id).scenarios.size() + two.buffers.of(first.id).scenarios.size(),
              2u);
}

TEST_F(Allocating, ABufferTakenBackWaitsBeforeTheOthers) {
    DispatchJob& job = open("best-match", 2);
    WorkerProxy& one = join(1);
    queue.set_paused(false);
    tasks.send_range(one, job, {{0, 9}}, 1, actions);
    tasks.send_range(one, job, {{9, 9}}, 1, actions); // No room for a third task.
    actions.clear();
    add(job, 3);
    allocator.settle(actions);
    EXPECT_EQ(one.buffers.count(), 2u);
    allocator.take_back_buffers(one);
    EXPECT_EQ(job.waiting, (std::deque<std::uint64_t>{0, 1, 2}));
    EXPECT_TRUE(actions.empty());
}

TEST_F(Allocating, ASuspectEmptiesTheBuffersOfTheWorkerThatIsReservedForIt) {
    DispatchJob& job = open("best-match", 3);
    WorkerProxy& one = join(1);
    queue.set_paused(false);
    tasks.send_range(one, job, {{0, 1}}, 1, actions); // The worker is busy.
    add(job, 1);
    allocator.settle(actions);
    EXPECT_EQ(one.buffers.count(), 1u);
    actions.clear();
    DispatchScenario suspect = scenario(job);
    suspect.losses.add(1);
    suspect.losses.add(2);
    queue.add(job, next++, suspect);
    allocator.take_up(job, true, false, actions);
    EXPECT_EQ(sent(), Lists{{0}});
    EXPECT_FALSE(filler.is_ripe(one, job));
}

TEST_F(Allocating, ASuspectTravelsAloneToAnIdleWorkerThatItClaims) {
    DispatchJob& job = open("best-match", 2);
    WorkerProxy& one = join(1);
    add(job, 1);
    DispatchScenario suspect = scenario(job);
    suspect.losses.add(1);
    suspect.losses.add(2);
    queue.add(job, next++, suspect);
    allocator.settle(actions);
    EXPECT_EQ(sent(), Lists{{1}});
    EXPECT_TRUE(one.is_claimed());
    EXPECT_EQ(job.waiting.size(), 1u);
}

TEST_F(Allocating, AFreeWorkerPulls) {
    DispatchJob& job = open("best-match-pull", 2);
    WorkerProxy& one = join(1);
    queue.set_paused(false);
    add(job, 1);
    allocator.take_up(job, false, true, actions);
    EXPECT_TRUE(actions.empty());
    add(job, 1);
    allocator.take_up(job, false, false, actions);
    EXPECT_EQ(sent(), (Lists{{0, 1}}));
    EXPECT_EQ(one.buffers.count(), 0u);
}

} // namespace
} // namespace cd::tests
