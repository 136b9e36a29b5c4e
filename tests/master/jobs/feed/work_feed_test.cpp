// Proves which jobs are fed, by analysis or in ranges, and in which turn.
#include "master/jobs/feed/work_feed.hpp"

#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::IsEmpty;

class WorkFeedTest : public PartsStage {
  protected:
    /// Opens a job of many blocks of scenarios, in none of which the bodies meet.
    MasterJob& open_large(std::int32_t priority = 0) {
        Grid grid;
        grid.position = {GridAxis{100, 200, 2000}, GridAxis{0, 0, 1}, GridAxis{0, 0, 1}};
        Submit submit = submission(AnalysisMode::Always);
        submit.grid = encode_grid(grid);
        submit.scenarios = grid.count();
        submit.poses.kind = PosesKind::Grid;
        submit.priority = priority;
        return open(submit, std::make_shared<OrderedPoses>(grid));
    }
    [[nodiscard]] static bool is_fed(const MasterJob& job) {
        return job.work()->todo.left() != job.submit.scenarios;
    }

    WorkFeed& work_ = services.work;
};

TEST_F(WorkFeedTest, AJobIsSentInRangesOrAnalysedAsItsClientAsks) {
    MasterJob& ranges = open(AnalysisMode::Never);
    MasterJob& analysed = open(AnalysisMode::Always);
    join(70);
    work_.feed();
    EXPECT_EQ(ranges.work()->analyser, nullptr);
    EXPECT_EQ(ranges.work()->positions_loading, 90u);
    EXPECT_NE(analysed.work()->analyser, nullptr);
    EXPECT_EQ(analysed.work()->positions_loading, 0u);
}

TEST_F(WorkFeedTest, LooksAgainWhilePositionsWaitAndAWorkerIsIdle) {
    MasterJob& first = open(AnalysisMode::Never);
    const WorkerId idle = join(71); // Gets no work.
    state.dispatch.act(state.dispatch->worker_draining(idle));
    join(70);
    work_.feed();
    run_until([&] { return state.dispatch.view().positions_unsent(first.id) != 0; });
    work_.feed();
    MasterJob& second = open(AnalysisMode::Never);
    EXPECT_EQ(second.work()->todo.left(), 90u);
    run_until([&] { return second.work()->todo.empty(); });
}

TEST_F(WorkFeedTest, StrictClaimingIsAnalysed) {
    Submit submit = submission(AnalysisMode::Never);
    submit.cluster.claim = true;
    MasterJob& job = open(submit);
    join(70);
    work_.feed();
    EXPECT_NE(job.work()->analyser, nullptr);
    EXPECT_EQ(job.work()->positions_loading, 0u);
}

TEST_F(WorkFeedTest, LostPositionsAreAnalysedWhateverTheClientAsks) {
    MasterJob& job = open(AnalysisMode::Never);
    job.work()->todo = PositionQueue(90, std::vector<LostPositions>{{{0, 90}, 71}});
    join(70);
    work_.feed();
    EXPECT_NE(job.work()->analyser, nullptr);
    EXPECT_EQ(job.work()->positions_loading, 0u);
}

TEST_F(WorkFeedTest, JobsAreAnalysedInTurnWhileThePoolHasRoom) {
    MasterJob& first = open_large();
    MasterJob& second = open_large();
    const auto released = occupy(compute);
    work_.feed();
    EXPECT_EQ(first.work()->analyses_under_way(), 2u);
    EXPECT_EQ(second.work()->analyses_under_way(), 2u);
    work_.feed();
    EXPECT_EQ(first.work()->analyses_under_way(), 2u) << "the pool has enough to do";
    released->count_down();
}

TEST_F(WorkFeedTest, AHigherPriorityIsAnalysedFirst) {
    MasterJob& low = open_large(-1);
    MasterJob& high = open_large(1);
    const auto released = occupy(compute);
    work_.feed();
    EXPECT_EQ(low.work()->analyses_under_way(), 0u);
    EXPECT_EQ(high.work()->analyses_under_way(), 4u);
    released->count_down();
}

TEST_F(WorkFeedTest, TheJobOfWhichLessWasAnalysedComesFirst) {
    MasterJob& first = open_large();
    MasterJob& second = open_large();
    state.dispatch->analysis_took(first.id, 1000, 0);
    EXPECT_TRUE(state.dispatch.view().is_analysed_before(second.id, first.id));
    state.dispatch->analysis_took(second.id, 10, 1.5);
    EXPECT_TRUE(state.dispatch.view().is_analysed_before(first.id, second.id));
}

TEST_F(WorkFeedTest, AJobThatWaitsForTheDiskIsFedWhenItsStepIsRepeated) {
    MasterJob& job = open();
    MasterJob& other = open();
    services.life.wait_for_disk(job, {ErrorCode::Io, "no space"}, [](MasterJob*) {});
    work_.feed();
    EXPECT_FALSE(is_fed(job));
    EXPECT_TRUE(is_fed(other));
    run_until([&] { return is_fed(job); });
    EXPECT_FALSE(services.life.is_waiting(job.id));
}

TEST_F(WorkFeedTest, AResumedJobIsFedWhenItsWorkersHaveToldAll) {
    MasterJob& job = open();
    state.awaited = AwaitedWorkers({job.id}, {70}, Clock::now() + std::chrono::hours(1));
    work_.feed();
    EXPECT_FALSE(is_fed(job));
    state.awaited.has_told_all(70);
    work_.feed();
    EXPECT_TRUE(is_fed(job));
}

TEST_F(WorkFeedTest, AJobWithoutGeometryIsNotFed) {
    MasterJob& job = begin(submission(AnalysisMode::Always));
    work_.feed();
    EXPECT_EQ(job.work(), nullptr);
}

TEST_F(WorkFeedTest, BufferedScenariosAreSentWhenNoMoreFollow) {
    Scenario only = reference().scenarios[scenario_with_contact()];
    only.index = 0;
    Submit submit = submission(AnalysisMode::Always);
    submit.scenarios = 1;
    join(70);
    open(submit, ordered(std::vector{only}));
    work_.feed();
    run_until([this, before = outcomes] { return outcomes == before + 1; });
    EXPECT_THAT(performed<SendUnit>(), IsEmpty()) << "the buffer has room for more";
    work_.feed();
    ASSERT_EQ(performed<SendUnit>().size(), 1u);
    EXPECT_EQ(performed<SendUnit>()[0].positions, (PositionRange{0, 1}));
}

} // namespace
} // namespace cd::tests
