// Proves that an analysed scenario is answered by the master or given to the dispatcher, unless it
// has a result, and that positions that cannot be analysed are queued again.
#include "master/jobs/feed/analysis_feed.hpp"

#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

class AnalysisFeedTest : public PartsStage {
  protected:
    /// Analyses all scenarios of the job, which are one block.
    void start(MasterJob& job) {
        services.analyses.start(job);
        EXPECT_TRUE(job.work()->todo.empty());
    }
    void run_until_analysed() {
        run_until([this, before = outcomes] { return outcomes == before + 1; });
    }

    [[nodiscard]] static bool is_open(const MasterJob& job, std::uint64_t index) {
        return job.work()->open.has(position_of(job, index));
    }

    const std::uint64_t touching_ = scenario_with_contact();
};

TEST_F(AnalysisFeedTest, EachScenarioIsAnsweredByTheMasterOrGivenToTheDispatcher) {
    MasterJob& job = open();
    start(job);
    run_until_analysed();
    const JobWork& work = *job.work();
    EXPECT_TRUE(is_open(job, touching_));
    EXPECT_EQ(state.dispatch.view().unanswered(job.id), work.open.size());
    EXPECT_EQ(job.tally.answered_by_master, job.merged.summary().merged());
    EXPECT_GT(job.tally.answered_by_master, 0u);
    for (const Scenario& scenario : reference().scenarios) {
        EXPECT_NE(job.merged.has(scenario.index), is_open(job, scenario.index));
        EXPECT_EQ(job.merged.author_of(scenario.index), nullptr);
    }
}

TEST_F(AnalysisFeedTest, MeasuresTheBytesThatAnalysisAddsOnTheWire) {
    MasterJob& job = open();
    start(job);
    run_until_analysed();
    const JobWork& work = *job.work();
    std::uint64_t bytes = 0;
    for (const auto& [position, analysis] : work.open.all()) {
        bytes += sizeof(std::uint32_t) + analysis->pairs.size() * sizeof(RootPair);
    }
    EXPECT_DOUBLE_EQ(work.rates.bytes.value() * static_cast<double>(work.open.size()),
                     static_cast<double>(bytes));
}

TEST_F(AnalysisFeedTest, AScenarioThatHasAResultIsNotGivenToTheDispatcher) {
    MasterJob& job = open();
    std::uint64_t next = touching_ + 1;
    while (right_result(next).pair_count == 0) {
        ++next;
    }
    merge(job, right_result(touching_), 70);
    start(job);
    merge(job, right_result(next), 70); // It is answered while the pool analyses it.
    run_until_analysed();
    EXPECT_FALSE(is_open(job, touching_));
    EXPECT_FALSE(is_open(job, next));
    EXPECT_EQ(job.merged.author_of(next)->process, 70u);
    EXPECT_EQ(job.run->disputes, 0u);
}

TEST_F(AnalysisFeedTest, AJobThatTheMasterAnswersAloneEnds) {
    std::vector<Scenario> apart(3);
    for (std::uint64_t index = 0; index < apart.size(); ++index) {
        apart[index].index = index;
        apart[index].poses.b = translation_pose(100, 0, 0);
    }
    Submit submit = submission(AnalysisMode::Always);
    submit.scenarios = apart.size();
    MasterJob& job = open(submit, ordered(apart));
    start(job);
    run_until_analysed();
    ASSERT_FALSE(job.is_running());
    EXPECT_EQ(job.end->state, JobState::Done);
    EXPECT_EQ(job.merged.summary().separate, 3u);
}

TEST_F(AnalysisFeedTest, PosesThatCannotBeReadAreQueuedAgainWithTheirLosses) {
    MasterJob& job = open(submission(AnalysisMode::Always), failing_poses());
    job.work()->todo = PositionQueue(90, std::vector<LostPositions>{{{0, 90}, 70}});
    start(job);
    run_until_analysed();
    EXPECT_EQ(job.run->paused, "the disk is gone");
    EXPECT_TRUE(services.life.is_waiting(job.id));
    EXPECT_EQ(job.work()->todo.front().positions, (PositionRange{0, 90}));
    EXPECT_EQ(job.work()->todo.front().losses.count(), 1u);
    start(job);
    run_until_analysed();
    EXPECT_TRUE(is_open(job, touching_));
}

TEST_F(AnalysisFeedTest, AScenarioLostTooOftenIsGivenUp) {
    MasterJob& job = open();
    std::vector<LostPositions> losses;
    for (InstanceId process = 1; process <= limits::scenario_losses_max; ++process) {
        losses.push_back({{position_of(job, touching_), 1}, process});
    }
    job.work()->todo = PositionQueue(90, losses);
    while (job.work()->todo.front().losses.none()) {
        services.analyses.start(job);
        run_until_analysed();
    }
    EXPECT_EQ(performed<GiveUp>().size(), 0u);
    services.analyses.start(job);
    run_until_analysed();
    ASSERT_EQ(performed<GiveUp>().size(), 1u);
    EXPECT_TRUE(job.merged.is_failed_by_master(touching_));
    EXPECT_FALSE(is_open(job, touching_));
}

} // namespace
} // namespace cd::tests
