// Proves what happens to a task: sent, answered, copied, asked back, ended or lost.
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

#include <deque>

namespace cd::tests {
namespace {

class TaskTables : public testing::Test, protected DispatchStage {
  protected:
    void answer(std::uint64_t index, WorkerId by) {
        tasks.withdraw(job_, index, job_.at(index), by, actions);
        job_.scenarios.erase(index);
    }

    DispatchJob& job_ = open("earliest-finish");
    WorkerProxy& one_ = join(1);
    WorkerProxy& two_ = join(2);
};

TEST_F(TaskTables, ATaskOwesWhatIsNotAnswered) {
    add(job_, 3);
    send(one_, job_, 2);
    const TaskId task = last<SendBatch>().task;
    EXPECT_EQ(last<SendBatch>().scenarios, (std::vector<std::uint64_t>{0, 1}));
    EXPECT_EQ(queue.unsent(), 1u);
    EXPECT_EQ(tasks.owed(one_.id(), task), 2u);
    answer(0, one_.id());
    EXPECT_EQ(tasks.owed(one_.id(), task), 1u);
    EXPECT_EQ(tasks.owed(two_.id(), task), 0u);
    one_.set_draining();
    EXPECT_EQ(tasks.owed(one_.id(), task), 0u);
}

TEST_F(TaskTables, TheRestOfAnEndedTaskWaitsFirst) {
    add(job_, 3);
    send(one_, job_, 2);
    EXPECT_EQ(tasks.end(one_, last<SendBatch>().task, std::nullopt, actions).left(), 2u);
    EXPECT_EQ(job_.waiting, (std::deque<std::uint64_t>{0, 1, 2}));
    EXPECT_EQ(queue.unsent(), 3u);
    EXPECT_TRUE(job_.at(0).losses.none());
}

TEST_F(TaskTables, EachLossIsToldAndTheLastGivesUp) {
    add(job_, 1);
    for (std::uint32_t lost = 1; lost <= limits::scenario_losses_max; ++lost) {
        if (lost == limits::scenario_losses_max) {
            ASSERT_EQ(queue.take_suspect().scenario, 0u);
            tasks.send(one_, job_, {0}, true, actions);
        } else {
            send(one_, job_, 1);
        }
        tasks.end(one_, last<SendBatch>().task, InstanceId{lost}, actions);
        EXPECT_EQ(last<ScenariosLost>().process, lost);
    }
    EXPECT_EQ(std::get<GiveUp>(actions.at(actions.size() - 2)), (GiveUp{job_.id, 0}));
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

TEST_F(TaskTables, AnAnswerCallsTheOtherCopyOff) {
    add(job_, 1);
    send(one_, job_, 1);
    const TaskId first = last<SendBatch>().task;
    tasks.send_copy(two_, job_, 0, false, actions);
    EXPECT_TRUE(last<SendBatch>().is_copy);
    answer(0, two_.id());
    EXPECT_EQ(last<CallOff>(), (CallOff{one_.id(), first, job_.id, 0}));
    EXPECT_EQ(one_.tasks.left() + two_.tasks.left(), 0u);
    EXPECT_EQ(one_.tasks.answered(), 0u);
    EXPECT_EQ(two_.tasks.answered(), 1u);
}

TEST_F(TaskTables, LosingACopyLosesNothing) {
    add(job_, 1);
    send(one_, job_, 1);
    tasks.send_copy(two_, job_, 0, false, actions);
    tasks.lose_all(two_, actions);
    EXPECT_TRUE(job_.at(0).losses.none());
    EXPECT_EQ(queue.unsent(), 0u);
    EXPECT_EQ(one_.tasks.left(), 1u);
}

TEST_F(TaskTables, AnUnsentScenarioLeavesQueueOrBuffer) {
    add(job_, 2);
    job_.waiting.pop_front();
    job_.at(0).where = Whereabouts::Buffered;
    job_.at(0).worker = one_.id();
    one_.buffers.add(job_.id, 0, job_.at(0).weight);
    answer(0, two_.id());
    answer(1, two_.id());
    EXPECT_EQ(queue.unsent(), 0u);
    EXPECT_TRUE(one_.is_idle());
}

TEST_F(TaskTables, ReturnedScenariosWaitAndAShortReturnMeansTheRestHasBegun) {
    add(job_, 3);
    send(one_, job_, 3);
    const TaskId task = last<SendBatch>().task;
    tasks.ask_back({one_.id(), task, {1, 2}, 0}, 2, two_.id(), actions);
    EXPECT_EQ(tasks.recalls().at(one_.id()).helper, two_.id());
    tasks.take_recalled(one_, {task, {2, 99}, 0}, actions);
    EXPECT_EQ(last<GivenBack>().scenarios, 1u);
    EXPECT_EQ(job_.waiting, std::deque<std::uint64_t>{2});
    EXPECT_EQ(job_.at(2).recalls, 1u);
    EXPECT_TRUE(one_.tasks.at(task).has_begun);
    EXPECT_TRUE(tasks.recalls().empty());
}

TEST_F(TaskTables, ARangeIsCutCopiedAndEnded) {
    tasks.send_places(one_, job_, {10, 10}, 100, actions);
    const TaskId task = last<SendRange>().task;
    EXPECT_EQ(one_.tasks.cost_ns(), 1000u);
    tasks.take_recalled(one_, {task, {}, 6}, actions);
    EXPECT_EQ(last<GivenBack>().places, (PlaceRange{16, 4}));
    tasks.copy_places(one_, task, two_, 2, actions);
    EXPECT_EQ(last<SendRange>().places, (PlaceRange{14, 2}));
    EXPECT_EQ(last<SendRange>().copy_of, task);
    EXPECT_EQ(two_.tasks.cost_ns(), 200u);
    tasks.copy_places(one_, task, two_, 1, actions);
    EXPECT_EQ(last<SendRange>().places, (PlaceRange{13, 1}));
    tasks.end(one_, task, InstanceId{5}, actions);
    EXPECT_EQ(last<RangeEnded>(), (RangeEnded{task, job_.id, {10, 6}, InstanceId{5}}));
}

} // namespace
} // namespace cd::tests
