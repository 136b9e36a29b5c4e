// Proves which work of a straggler is copied, and how much of it.
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

class Copies : public testing::Test, protected DispatchStage {
  protected:
    /// Sends scenarios to the first worker.
    TaskId give(std::uint64_t count, std::uint64_t cost_ns) {
        add(job_, count, cost_ns);
        send(one_, job_, count);
        return last<SendUnit>().task;
    }
    /// Sends ten positions without analysis, each predicted to take a second, to the first worker,
    /// which is a thousand times slower than the second.
    TaskId give_range() {
        pace.add_scenario(1'000'000'000);
        job_.range_pace.add(one_.id(), 1, 1);
        job_.range_pace.add(two_.id(), 1000, 1);
        tasks.send_range(one_, job_, {{0, 10}}, 1'000'000'000, actions);
        return last<SendUnit>().task;
    }
    bool copy() { return copies_.copy(one_, two_, actions); }

    DispatchJob& job_ = open("earliest-finish");
    Stragglers stragglers_{context, tasks};
    SpeculativeCopies copies_{context, tasks, blocks, stragglers_};
    WorkerProxy& one_ = join(1);
    WorkerProxy& two_ = join(2);
};

TEST_F(Copies, AScenarioIsCopiedOnceAndWithinTheBudget) {
    const TaskId task = give(1, 1'000'000'000);
    pace.time_is(3); // Overdue by two seconds.
    EXPECT_FALSE(copy()) << "a copy would double all work";
    job_.copies.add_work(20'000'000'000);
    EXPECT_TRUE(copy());
    EXPECT_EQ(last<SendUnit>(),
              (SendUnit{two_.id(), TaskId{2}, job_.id, PositionRange{0, 1}, true, task}));
    EXPECT_FALSE(copy());
}

TEST_F(Copies, ACopyPaysIfTheHelperIsMuchEarlier) {
    give(1, 1'000'000'000);
    job_.copies.add_work(100'000'000'000);
    EXPECT_FALSE(copy()) << "both need a second";
    pace.time_is(2.2); // Overdue by 1.2 s; the helper needs a second and the transfer.
    EXPECT_FALSE(copy());
    pace.time_is(2.7);
    EXPECT_TRUE(copy());
}

TEST_F(Copies, TheHelperIsPlannedToHoldTheBlocks) {
    give(1, 1'000'000'000);
    job_.copies.add_work(100'000'000'000);
    pace.time_is(3);
    EXPECT_TRUE(copy());
    EXPECT_EQ(plan.held_triangles(two_.slot()), 101u);
    EXPECT_TRUE(tasks.find({two_.id(), TaskId{2}})->fetches);
}

TEST_F(Copies, TheLastPositionsOfARangeAreCopied) {
    const TaskId task = give_range();
    job_.copies.add_work(50'000'000'000); // Three of 60 may be copied.
    EXPECT_TRUE(copy());
    EXPECT_EQ(last<SendUnit>().positions, (PositionRange{7, 3}));
    EXPECT_EQ(last<SendUnit>().copy_of, task);
}

TEST_F(Copies, PositionsAreCopiedOnceAndInOneRun) {
    const TaskId task = give_range();
    one_.tasks.remove(task, PositionRange{8, 1}, 1'000'000'000);
    job_.copies.add_work(50'000'000'000);
    EXPECT_TRUE(copy());
    EXPECT_EQ(last<SendUnit>().positions, (PositionRange{9, 1}));
    tasks.lose_all(two_, actions);
    EXPECT_TRUE(copy());
    EXPECT_EQ(last<SendUnit>().positions, (PositionRange{6, 2})) << "the lost copy is not repeated";
}

} // namespace
} // namespace cd::tests
