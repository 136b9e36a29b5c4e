// Proves who is late at the end of a job, and who can help.
#include "common/core/timing/master.hpp"
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using Workers = std::vector<WorkerProxy*>;

class Late : public testing::Test, protected DispatchStage {
  protected:
    void give(WorkerProxy& proxy, std::uint64_t count) {
        add(job_, count, 100'000'000);
        send(proxy, job_, count);
    }

    DispatchJob& job_ = open("earliest-finish");
    Stragglers stragglers_{context, tasks};
    WorkerProxy& one_ = join(1);
    WorkerProxy& two_ = join(2, 2);
};

TEST_F(Late, AWorkerEndsAfterItsWorkAndAnOverdueOneInAsLongAsItIsOverdue) {
    give(one_, 3);
    EXPECT_DOUBLE_EQ(stragglers_.ends_in(one_), 0.3);
    pace.time_is(0.1);
    EXPECT_DOUBLE_EQ(stragglers_.ends_in(one_), 0.2);
    pace.time_is(0.5);
    EXPECT_DOUBLE_EQ(stragglers_.ends_in(one_), 0.2);
    EXPECT_EQ(stragglers_.ends_in(two_), 0);
}

TEST_F(Late, ARangeEndsAtItsMeasuredRate) {
    job_.range_pace.add(two_.id(), 5, 1);
    tasks.send_range(two_, job_, {{0, 20}}, 1, actions);
    EXPECT_DOUBLE_EQ(stragglers_.ends_in(two_), 2); // 20 scenarios at 10/s.
}

TEST_F(Late, PositionsMoveSoThatBothEndTogetherIfTheGainIsLargeEnough) {
    job_.range_pace.add(one_.id(), 100, 1);
    job_.range_pace.add(two_.id(), 100, 1);
    // The helper begins after 0.02 s, and does 200 positions/s beside the 100 of the straggler.
    EXPECT_EQ(stragglers_.positions_to_move(one_, job_, two_, 0.63, 1), 40u);
    EXPECT_EQ(stragglers_.positions_to_move(one_, job_, two_, 0.63, 20), 40u);
    EXPECT_EQ(stragglers_.positions_to_move(one_, job_, two_, 0.63, 22), 0u) << "0.03 s for one";
}

TEST_F(Late, HelpersHaveFreeThreadsTheFastestFirst) {
    EXPECT_EQ(stragglers_.helpers(), (Workers{&two_, &one_}));
    give(two_, 1);
    EXPECT_TRUE(stragglers_.can_help(two_));
    give(one_, 1);
    EXPECT_EQ(stragglers_.helpers(), Workers{&two_});
    two_.set_silent(true);
    EXPECT_TRUE(stragglers_.helpers().empty());
}

TEST_F(Late, TheLatestIsHelpedFirst) {
    give(one_, 1);
    give(two_, 8);
    EXPECT_EQ(stragglers_.late(), (Workers{&two_, &one_}));
}

TEST_F(Late, AWorkerThatIsAskedIsLeftAloneUntilItShouldHaveAnswered) {
    give(one_, 3);
    const TaskId task = last<SendUnit>().task;
    tasks.ask_back({one_.id(), task, PositionRange{2, 1}}, two_.id(), actions);
    EXPECT_FALSE(stragglers_.may_be_asked(one_));
    EXPECT_TRUE(stragglers_.may_answer_recall(one_));
    EXPECT_FALSE(stragglers_.can_help(two_)); // It will get what is asked back.
    EXPECT_TRUE(stragglers_.late().empty());
    pace.time_is(timing::recall_answer_seconds);
    EXPECT_FALSE(stragglers_.may_answer_recall(one_));
    EXPECT_TRUE(stragglers_.can_help(two_));
    EXPECT_EQ(stragglers_.late(), Workers{&one_}); // By a copy.
}

} // namespace
} // namespace cd::tests
