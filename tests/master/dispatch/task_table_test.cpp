// Proves what happens to a task: sent, answered, copied, asked back, ended or lost.
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <set>

namespace cd::tests {
namespace {

class TaskTables : public testing::Test, protected DispatchStage {
  protected:
    TaskTable::Relieved answer(WorkerId by, TaskId task, const PositionSet& positions) {
        return tasks.answer(job_, {by, task, job_.id, positions}, actions);
    }
    /// Sends a range to the first worker.
    TaskId send_range(const PositionRange& positions) {
        tasks.send_range(one_, job_, {positions}, 100, actions);
        return last<SendUnit>().task;
    }

    DispatchJob& job_ = open("earliest-finish");
    WorkerProxy& one_ = join(1);
    WorkerProxy& two_ = join(2);
};

TEST_F(TaskTables, ATaskOwesWhatIsNotAnswered) {
    add(job_, 3);
    send(one_, job_, 2);
    const TaskId task = last<SendUnit>().task;
    EXPECT_EQ(last<SendUnit>().positions, (PositionRange{0, 2}));
    EXPECT_EQ(queue.unsent(), 1u);
    EXPECT_EQ(tasks.owed({one_.id(), task}), 2u);
    EXPECT_EQ(answer(one_.id(), task, PositionRange{0, 1}).workers, std::set{one_.id()});
    EXPECT_EQ(tasks.owed({one_.id(), task}), 1u);
    EXPECT_EQ(tasks.owed({two_.id(), task}), 0u);
    one_.set_draining();
    EXPECT_EQ(tasks.owed({one_.id(), task}), 0u);
}

TEST_F(TaskTables, TheRestOfAnEndedTaskWaitsFirst) {
    add(job_, 3);
    send(one_, job_, 2);
    EXPECT_EQ(tasks.end(one_, last<SendUnit>().task, std::nullopt, actions).left(), 2u);
    EXPECT_EQ(job_.waiting, (std::deque<std::uint64_t>{0, 1, 2}));
    EXPECT_EQ(queue.unsent(), 3u);
    EXPECT_TRUE(job_.at(0).losses.none());
}

TEST_F(TaskTables, EachLossIsToldAndTheLastGivesUp) {
    add(job_, 1);
    for (std::uint32_t lost = 1; lost < limits::scenario_losses_max; ++lost) {
        send(one_, job_, 1);
        tasks.end(one_, last<SendUnit>().task, InstanceId{lost}, actions);
        EXPECT_EQ(last<PositionsLost>(), (PositionsLost{job_.id, PositionRange{0, 1}, true, lost}));
    }
    ASSERT_EQ(queue.take_suspect().position, 0u);
    tasks.send(one_, job_, {0}, true, actions);
    tasks.end(one_, last<SendUnit>().task, InstanceId{99}, actions);
    EXPECT_EQ(last<GiveUp>(), (GiveUp{job_.id, 0}));
    EXPECT_TRUE(job_.scenarios.empty());
    EXPECT_EQ(queue.unsent(), 0u);
}

TEST_F(TaskTables, ALostWorkersTasksWaitInTheOrderSent) {
    add(job_, 4);
    send(one_, job_, 2);
    send(one_, job_, 2);
    tasks.lose_all(one_, actions);
    EXPECT_EQ(job_.waiting, (std::deque<std::uint64_t>{0, 1, 2, 3}));
    EXPECT_TRUE(one_.is_idle());
}

TEST_F(TaskTables, AnAnswerCallsTheOtherTaskOff) {
    add(job_, 1);
    send(one_, job_, 1);
    const TaskId first = last<SendUnit>().task;
    tasks.send_copy({one_.id(), first}, two_, PositionRange{0, 1}, false, actions);
    EXPECT_EQ(last<SendUnit>().copy_of, first);
    answer(two_.id(), last<SendUnit>().task, PositionRange{0, 1});
    EXPECT_EQ(last<CallOff>(), (CallOff{one_.id(), first, PositionRange{0, 1}}));
    EXPECT_EQ(one_.tasks.left() + two_.tasks.left(), 0u);
    EXPECT_EQ(one_.tasks.answered(), 0u);
    EXPECT_EQ(two_.tasks.answered(), 1u);
    EXPECT_TRUE(job_.scenarios.empty());
}

TEST_F(TaskTables, AnAnswerOfARangeCallsItsCopiesOff) {
    const TaskId first = send_range({10, 10});
    tasks.send_copy({one_.id(), first}, two_, PositionRange{16, 4}, false, actions);
    const TaskId copy = last<SendUnit>().task;
    EXPECT_FALSE(last<SendUnit>().is_analysed);
    answer(one_.id(), first, PositionSet::of({10, 16, 17}));
    EXPECT_EQ(last<CallOff>(), (CallOff{two_.id(), copy, PositionRange{16, 2}}));
    EXPECT_EQ(tasks.owed({two_.id(), copy}), 2u);
    answer(two_.id(), copy, PositionRange{18, 2});
    EXPECT_EQ(last<CallOff>(), (CallOff{one_.id(), first, PositionRange{18, 2}}));
    EXPECT_EQ(one_.tasks.at(first).positions, (PositionRange{11, 5}));
}

TEST_F(TaskTables, LosingACopyLosesNothing) {
    add(job_, 1);
    send(one_, job_, 1);
    tasks.send_copy({one_.id(), last<SendUnit>().task}, two_, PositionRange{0, 1}, false, actions);
    tasks.lose_all(two_, actions);
    EXPECT_TRUE(job_.at(0).losses.none());
    EXPECT_EQ(queue.unsent(), 0u);
    EXPECT_EQ(one_.tasks.left(), 1u);
}

TEST_F(TaskTables, ACopyOutlivesItsOriginal) {
    add(job_, 2);
    send(one_, job_, 2);
    tasks.send_copy({one_.id(), last<SendUnit>().task}, two_, PositionRange{1, 1}, false, actions);
    tasks.lose_all(one_, actions);
    EXPECT_EQ(job_.waiting, std::deque<std::uint64_t>{0});
    EXPECT_EQ(job_.at(1).at.worker, two_.id());
    tasks.lose_all(two_, actions);
    EXPECT_EQ(job_.waiting, (std::deque<std::uint64_t>{1, 0}));
}

TEST_F(TaskTables, AnUnsentScenarioLeavesQueueOrBuffer) {
    add(job_, 2);
    job_.waiting.pop_front();
    job_.at(0).where = Whereabouts::Buffered;
    job_.at(0).at.worker = one_.id();
    one_.buffers.add(job_.id, 0, job_.at(0).weight);
    EXPECT_TRUE(answer(two_.id(), {}, PositionRange{0, 2}).any_unsent);
    EXPECT_EQ(queue.unsent(), 0u);
    EXPECT_TRUE(one_.is_idle());
}

TEST_F(TaskTables, AnAnswerFromElsewhereFindsPositionsOfRanges) {
    send_range({10, 10});
    job_.unsent.add({{20, 10}}, 0);
    const std::size_t actions_before = actions.size();
    EXPECT_TRUE(answer(two_.id(), {}, PositionRange{18, 4}).any_unsent);
    EXPECT_EQ(job_.unsent.all(), (std::vector<PositionRange>{{22, 8}}));
    EXPECT_EQ(one_.tasks.left(), 8u);
    EXPECT_EQ(actions.size(), actions_before) << "a second answer is compared with the first";
}

TEST_F(TaskTables, RepeatedAnswersAreNotSearchedForInRanges) {
    send_range({10, 10});
    tasks.send_range(two_, job_, {{30, 10}}, 100, actions);
    const TaskId own = last<SendUnit>().task;
    const auto answer = [&](const PositionSet& positions, std::uint64_t repeated) {
        tasks.answer(job_, {two_.id(), own, job_.id, positions, 0, repeated}, actions);
        return one_.tasks.left();
    };
    EXPECT_EQ(answer(PositionRange{18, 2}, 2), 10u) << "the caller says that no range has them";
    EXPECT_EQ(answer(PositionSet::of({19, 30}), 1), 10u) << "the only new one is in its own task";
    EXPECT_EQ(answer(PositionSet::of({18, 19, 31}), 1), 8u) << "one new position is elsewhere";
    EXPECT_EQ(two_.tasks.left(), 8u);
}

TEST_F(TaskTables, ReturnedPositionsWaitAndAnEmptyReturnMeansTheRestHasBegun) {
    add(job_, 3);
    send(one_, job_, 3);
    const TaskId task = last<SendUnit>().task;
    tasks.ask_back({one_.id(), task, PositionRange{1, 2}}, two_.id(), actions);
    EXPECT_EQ(tasks.recalls().all().at(one_.id()).helper, two_.id());
    tasks.take_recalled(one_, task, PositionSet::of({2, 99}), actions);
    EXPECT_EQ(last<UnitsReturned>(), (UnitsReturned{job_.id, 1}));
    EXPECT_EQ(job_.waiting, std::deque<std::uint64_t>{2});
    EXPECT_EQ(job_.at(2).recalls, 1u);
    EXPECT_FALSE(one_.tasks.at(task).has_begun);
    EXPECT_TRUE(tasks.recalls().all().empty());
    tasks.ask_back({one_.id(), task, PositionRange{1, 1}}, two_.id(), actions);
    tasks.take_recalled(one_, task, PositionSet::of({2}), actions);
    EXPECT_TRUE(one_.tasks.at(task).has_begun);
}

TEST_F(TaskTables, UnansweredPositionsOfARangeGoOutAgainUnlessTheyAreLost) {
    const TaskId task = send_range({10, 10});
    EXPECT_EQ(one_.tasks.cost_ns(), 1000u);
    answer(one_.id(), task, PositionRange{10, 1});
    tasks.take_recalled(one_, task, PositionRange{16, 9}, actions);
    EXPECT_EQ(last<UnitsReturned>(), (UnitsReturned{job_.id, 4}));
    EXPECT_EQ(job_.unsent.all(), (std::vector<PositionRange>{{16, 4}}));
    EXPECT_EQ(one_.tasks.cost_ns(), 500u);
    tasks.end(one_, task, InstanceId{5}, actions);
    EXPECT_EQ(last<PositionsLost>(), (PositionsLost{job_.id, PositionRange{11, 5}, false, 5}));
    EXPECT_EQ(job_.unsent.count(), 4u);
}

} // namespace
} // namespace cd::tests
