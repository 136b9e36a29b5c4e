// Proves when the end of a job begins, what is asked back then, and when work is copied instead.
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

class Endgames : public testing::Test, protected DispatchStage {
  protected:
    TaskId give(std::uint64_t count, std::uint64_t cost_ns = 100'000'000) {
        add(job_, count, cost_ns);
        send(one_, job_, count);
        return last<SendUnit>().task;
    }

    DispatchJob& job_ = open("earliest-finish");
    WorkerProxy& one_ = join(1);
    WorkerProxy& two_ = join(2);
};

TEST_F(Endgames, TheEndBeginsWhenNothingWaitsAndAWorkerIsFree) {
    EXPECT_FALSE(endgame.has_begun());
    give(2);
    EXPECT_TRUE(endgame.has_begun());
    queue.set_paused(false);
    EXPECT_FALSE(endgame.has_begun());
    endgame.help(0, actions);
    EXPECT_EQ(actions.size(), 1u);
}

TEST_F(Endgames, AsksBackTheLastScenariosThatTheOtherWouldEndEarlier) {
    const TaskId task = give(4);
    endgame.help(0, actions);
    EXPECT_EQ(last<AskBack>(), (AskBack{one_.id(), task, PositionRange{2, 2}}));
    EXPECT_EQ(tasks.recalls().all().at(one_.id()).task, task);
}

TEST_F(Endgames, StragglersAreSearchedOnceInAPeriod) {
    endgame.help(1, actions);
    give(4);
    pace.time_is(0.2);
    endgame.help(1, actions);
    EXPECT_TRUE(tasks.recalls().all().empty());
    endgame.help(0.1, actions);
    EXPECT_FALSE(tasks.recalls().all().empty());
}

TEST_F(Endgames, AsksForAsManyPositionsAsLetBothEndTogether) {
    job_.range_pace.add(one_.id(), 100, 1);
    tasks.send_range(one_, job_, {{0, 100}}, 1, actions);
    endgame.help(0, actions);
    EXPECT_EQ(last<AskBack>().positions,
              (PositionRange{51, 49})); // 0.49 s of the other, which begins 0.02 s later.
}

TEST_F(Endgames, CopiesWhatCannotBeAskedBack) {
    const TaskId task = give(1, 1'000'000'000);
    one_.tasks.set_begun(task);
    job_.copies.add_work(20'000'000'000);
    pace.time_is(3); // Overdue by two seconds.
    endgame.help(0, actions);
    EXPECT_EQ(last<SendUnit>().copy_of, task);
    EXPECT_TRUE(tasks.recalls().all().empty());
}

TEST_F(Endgames, CopiesNothingWhileARecallMayBeAnswered) {
    join(3);
    const TaskId task = give(2, 1'000'000'000);
    job_.copies.add_work(100'000'000'000);
    endgame.help(0, actions);
    EXPECT_EQ(last<AskBack>().task, task);
    endgame.help(0, actions);
    EXPECT_EQ(actions.size(), 2u);
}

TEST_F(Endgames, ThePapersStrategiesAreLeftAlone) {
    DispatchJob& paper = open("best-match", 8, 2);
    add(paper, 4, 100'000'000);
    send(one_, paper, 4);
    endgame.help(0, actions);
    EXPECT_EQ(actions.size(), 1u);
}

} // namespace
} // namespace cd::tests
