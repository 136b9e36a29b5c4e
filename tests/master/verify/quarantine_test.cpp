// Proves what becomes of the results and the work of a process that was wrong.
#include "master/verify/quarantine.hpp"

#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class QuarantineTest : public PartsStage {
  protected:
    /// Merges all results of the job: this one from process 70, all others from 71.
    void merge_all_but(MasterJob& job, std::uint64_t index) {
        (void)job.work()->todo.take(90);
        for (const Scenario& scenario : reference().scenarios) {
            merge(job, right_result(scenario.index), scenario.index == index ? 70 : 71);
        }
    }
};

TEST_F(QuarantineTest, ResultsOfRunningJobsAreWithdrawnAndHandedOutAgain) {
    MasterJob& job = open(AnalysisMode::Never);
    merge_all_but(job, 5);
    job.work()->done = job.merged.marks();
    services.quarantine.impose(*author(70));
    EXPECT_TRUE(state.alarms.is_quarantined(70));
    EXPECT_FALSE(job.merged.has(5));
    EXPECT_EQ(job.merged.summary().merged(), 89u);
    EXPECT_EQ(job.tally.withdrawn, 1u);
    EXPECT_EQ(job.work()->done, nullptr) << "an analysis must not skip it";
    run_until([&] { return job.work()->positions_loading == 0; });
    EXPECT_EQ(job.work()->todo.left(), 1u);
    run_until([&] { return job.results->count() == 89 && !job.results->has(5); });
}

TEST_F(QuarantineTest, AProcessIsPutInQuarantineOnce) {
    MasterJob& job = open(AnalysisMode::Never);
    services.quarantine.impose(*author(70));
    merge(job, right_result(5), 70);
    services.quarantine.impose(*author(70));
    EXPECT_TRUE(job.merged.has(5));
    EXPECT_EQ(state.alarms.record().quarantined.size(), 1u);
}

TEST_F(QuarantineTest, AWorkerInQuarantineHasNoWorkAndNoneIsLost) {
    const WorkerId liar = join(70);
    MasterJob& job = open();
    services.work.feed();
    run_until([this] { return services.tasks.book().size() != 0; });
    const std::uint64_t unanswered = state.dispatch.view().unanswered(job.id);
    services.quarantine.impose(*state.workers.find(liar)->author);
    EXPECT_TRUE(state.workers.find(liar)->is_quarantined);
    EXPECT_THAT(state.dispatch.view().workers(), IsEmpty());
    EXPECT_EQ(services.tasks.book().size(), 0u);
    EXPECT_EQ(state.dispatch.view().unanswered(job.id), unanswered);
    EXPECT_THAT(performed<PositionsLost>(), IsEmpty());
    const WorkerId honest = join(71);
    services.work.feed();
    EXPECT_NE(state.dispatch.view().worker_status(honest).working, 0u);
}

TEST_F(QuarantineTest, EndedJobsWithItsResultsAreNamedInAnAlarm) {
    MasterJob& with = open(AnalysisMode::Never);
    MasterJob& without = open(AnalysisMode::Never);
    merge(with, right_result(5), 70);
    merge(without, right_result(5), 71);
    services.life.end(with, JobState::Cancelled, "cancelled");
    services.life.end(without, JobState::Cancelled, "cancelled");
    services.quarantine.impose(*author(70));
    ASSERT_EQ(state.alarms.record().count, 1u);
    EXPECT_THAT(state.alarms.record().last.at(0), HasSubstr("cdctl verify: 1"));
    EXPECT_THAT(state.alarms.record().last.at(0), testing::Not(HasSubstr("2")));
    EXPECT_TRUE(with.merged.has(5)) << "an ended job stays as it is";
}

TEST_F(QuarantineTest, OnlyAJobThatSumsContactsHasItsMapWithdrawn) {
    MasterJob& job = open(AnalysisMode::Never);
    job.submit.query.level = Level::Count;
    withdraw_map(job, "a worker was wrong");
    EXPECT_EQ(job.map.withdrawn(), "");
    job.submit.query.level = Level::Pairs;
    withdraw_map(job, "a worker was wrong");
    withdraw_map(job, "another reason");
    EXPECT_EQ(job.map.withdrawn(), "a worker was wrong");
}

} // namespace
} // namespace cd::tests
