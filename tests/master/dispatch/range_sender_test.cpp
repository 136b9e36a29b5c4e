// Proves who gets a range, and how long it is.
#include "common/core/limits/master.hpp"
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

class RangeSending : public testing::Test, protected DispatchStage {
  protected:
    RangeSending() { pace.add_scenario(1'000'000); } // 1000 scenarios/s and thread.

    DispatchJob& job_ = open("earliest-finish");
};

TEST_F(RangeSending, EachWorkerGetsABatchesWorthAndTheNextBeforeItRunsDry) {
    WorkerProxy& one = join(1);
    job_.unsent.add({{0, 10'000}}, 0);
    filler.give_ranges(actions);
    EXPECT_EQ(last<SendUnit>().positions, (PositionRange{0, 100})); // 0.1 s.
    EXPECT_DOUBLE_EQ(last<SendUnit>().results_wait_seconds, 0.05);
    EXPECT_EQ(actions.size(), 1u);
    one.tasks.remove(last<SendUnit>().task, PositionRange{0, 1}, 0);
    ranges.forget_totals();
    filler.fill(one, actions);
    EXPECT_EQ(last<SendUnit>().positions, (PositionRange{100, 100}));
    EXPECT_FALSE(ranges.would_take(one, job_));
}

TEST_F(RangeSending, RangesOfManyWorkersAreLongAndTheirResultsWait) {
    constexpr std::uint64_t workers = 1000;
    for (std::uint64_t i = 1; i <= workers; ++i) {
        join(i);
    }
    job_.unsent.add({{0, 1'000'000'000}}, 0);
    filler.give_ranges(actions);
    ASSERT_EQ(actions.size(), workers);
    EXPECT_EQ(last<SendUnit>().positions.count(), 200u); // 0.2 s: 5,000 ranges/s.
    EXPECT_DOUBLE_EQ(last<SendUnit>().results_wait_seconds, 0.2);
    for (std::uint64_t i = workers + 1; i <= 10 * workers; ++i) {
        join(i);
    }
    filler.give_ranges(actions);
    EXPECT_EQ(last<SendUnit>().positions.count(), 1000u); // At most 1 s.
    EXPECT_DOUBLE_EQ(last<SendUnit>().results_wait_seconds, 1);
}

TEST_F(RangeSending, TheRestIsDividedInTwoSharesForEachWorker) {
    join(1);
    join(2, 3);
    job_.unsent.add({{0, 80}}, 0);
    filler.give_ranges(actions);
    EXPECT_EQ(std::get<SendUnit>(actions.at(0)).positions.count(), 10u);
    EXPECT_EQ(std::get<SendUnit>(actions.at(1)).positions.count(),
              26u); // 3/4 of the other 70, halved.
}

TEST_F(RangeSending, ARangeIsAsLongAsARoundTripWhileThatManyAreLeft) {
    TaskInFlight ended; // 0.05 s for the work of one thread, and as long for the way.
    ended.busy_seconds = 0.05;
    join(1).batch.judge(ended, false, 1, 0.1);
    job_.unsent.add({{0, 80}}, 0);
    filler.give_ranges(actions);
    EXPECT_EQ(std::get<SendUnit>(actions.at(0)).positions.count(), 50u);
}

TEST_F(RangeSending, AWorkerThatWouldBeLateGetsNone) {
    WorkerProxy& slow = join(1);
    WorkerProxy& quick = join(2);
    job_.range_pace.add(slow.id(), 1, 10);
    job_.range_pace.add(quick.id(), 1000, 1);
    job_.unsent.add({{0, 100}}, 0);
    ranges.forget_totals();
    EXPECT_FALSE(ranges.would_take(slow, job_));
    EXPECT_TRUE(ranges.would_take(quick, job_));
    job_.unsent.add({{100, 100'000}}, 0);
    ranges.forget_totals();
    EXPECT_TRUE(ranges.would_take(slow, job_));
}

TEST_F(RangeSending, TasksOfAnotherJobInTheSameEventDoNotHideThatAWorkerWouldBeLate) {
    WorkerProxy& slow = join(1, 4);
    WorkerProxy& quick = join(2);
    DispatchJob& other = open("earliest-finish", 2, 2);
    job_.range_pace.add(slow.id(), 1, 10);
    job_.range_pace.add(quick.id(), 1000, 1);
    job_.unsent.add({{0, 1}}, 0);
    ranges.forget_totals();
    EXPECT_FALSE(ranges.would_take(slow, job_));
    tasks.send_range(slow, other, {{0, 3}}, 1'000'000, actions);
    EXPECT_FALSE(ranges.would_take(slow, job_));
}

TEST_F(RangeSending, JobsTakeTurnsAndTheReservedWorkerIsSpared) {
    WorkerProxy& one = join(1, 20);
    DispatchJob& other = open("earliest-finish", 2, 2);
    job_.unsent.add({{0, 5}}, 0);
    other.unsent.add({{0, 5}}, 0);
    filler.give_ranges(actions);
    ASSERT_EQ(actions.size(), 2u);
    EXPECT_EQ(std::get<SendUnit>(actions[0]).job, job_.id);
    EXPECT_EQ(std::get<SendUnit>(actions[1]).job, other.id);
    DispatchScenario scenario = DispatchStage::scenario(job_);
    scenario.losses.add(1);
    scenario.losses.add(2);
    job_.unsent.add({{5, 5}}, 0);
    EXPECT_TRUE(ranges.would_take(one, job_));
    queue.add(job_, 0, scenario);
    EXPECT_FALSE(ranges.would_take(one, job_));
}

TEST_F(RangeSending, EnoughFillsEveryWorkerThatTakesWork) {
    join(1);
    join(2, 2);
    join(3).set_draining();
    job_.unsent.add({{0, 10'000}}, 0);
    EXPECT_EQ(ranges.enough(job_), 300u);
}

TEST_F(RangeSending, EnoughFallsWithWhatIsLeft) {
    join(1);
    join(2, 2);
    job_.unsent.add({{0, 10'000}}, 0);
    EXPECT_EQ(ranges.enough(job_), 300u);
    (void)job_.unsent.take_first(9'900);
    EXPECT_EQ(ranges.enough(job_), 50u); // Each worker gets half of its share of the last 100.
    (void)job_.unsent.take_first(99);
    EXPECT_EQ(ranges.enough(job_), 3u); // One for each thread.
}

TEST_F(RangeSending, TotalsOfManyWorkersServeSeveralEvents) {
    const std::uint64_t workers = 3 * limits::workers_per_event;
    for (std::uint64_t i = 1; i <= workers; ++i) {
        join(i);
    }
    job_.unsent.add({{0, 1'000'000}}, 0);
    EXPECT_EQ(ranges.enough(job_), 100 * workers);
    join(workers + 1);
    for (int event = 0; event < 2; ++event) {
        ranges.age_totals();
        EXPECT_EQ(ranges.enough(job_), 100 * workers);
    }
    ranges.age_totals();
    EXPECT_EQ(ranges.enough(job_), 100 * (workers + 1));
}

TEST_F(RangeSending, AFewWorkersAreCountedAtEachEvent) {
    join(1);
    job_.unsent.add({{0, 10'000}}, 0);
    EXPECT_EQ(ranges.enough(job_), 100u);
    join(2);
    EXPECT_EQ(ranges.enough(job_), 100u);
    ranges.age_totals();
    EXPECT_EQ(ranges.enough(job_), 200u);
}

} // namespace
} // namespace cd::tests
