// Proves that a job is opened for work when its geometry is loaded, unless it has ended before, and
// that a job whose geometry is missing waits for it.
#include "master/jobs/job_start.hpp"

#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class JobStartTest : public PartsStage {};

TEST_F(JobStartTest, ALoadedJobIsOpenForWork) {
    MasterJob& job = begin(submission(AnalysisMode::Always));
    EXPECT_EQ(job.work(), nullptr);
    EXPECT_TRUE(job.is_running());
    run_until([&] { return job.work() != nullptr; });
    EXPECT_EQ(job.work()->todo.left(), job.submit.scenarios);
    EXPECT_THAT(job.work()->trees, ElementsAre(TreeId{1}, TreeId{2}));
    EXPECT_THAT(job.tally.depths, ElementsAre(4, 3)) << "as submitted";
    EXPECT_EQ(state.dispatch.view().positions_unsent(job.id), 0u) << "the dispatcher knows it";
}

TEST_F(JobStartTest, TheMeshesOfAJobAreHeld) {
    begin(submission(AnalysisMode::Always));
    EXPECT_EQ(geometry->remove(reference().a.hash()).error().code, ErrorCode::Refused);
}

TEST_F(JobStartTest, AJobWithoutScenariosIsDoneAtOnce) {
    Submit submit = submission(AnalysisMode::Always);
    submit.scenarios = 0;
    MasterJob& job = begin(submit, ordered({}));
    run_until([&] { return !job.is_running(); });
    EXPECT_EQ(job.end->state, JobState::Done);
}

TEST_F(JobStartTest, AJobThatEndsWhileItsGeometryIsLoadedIsNotOpened) {
    MasterJob& job = begin(submission(AnalysisMode::Always));
    services.life.end(job, JobState::Cancelled, "cancelled");
    run_until([&] { return outcomes == 1; });
    EXPECT_THAT(state.trees.messages(), IsEmpty());
}

TEST_F(JobStartTest, AJobWhoseMeshIsMissingWaitsForIt) {
    const Mesh missing = make_sphere(1);
    Submit submit = submission(AnalysisMode::Always);
    submit.bodies[1].mesh = missing.hash();
    MasterJob& job = begin(submit);
    run_until([&] { return services.life.is_waiting(job.id); });
    EXPECT_THAT(job.run->paused, HasSubstr(to_hex(missing.hash())));
    store(missing);
    run_until([&] { return job.work() != nullptr; });
    EXPECT_EQ(job.run->paused, "");
}

TEST_F(JobStartTest, AResumedJobKeepsItsLosses) {
    RecoveredJob before;
    before.record = {JobId{5}, submission(AnalysisMode::Always)};
    before.merger = ResultMerger(before.record.submit.scenarios);
    before.losses = {{{10, 5}, 70}};
    before.results = ResultStore::create(
        journal->results_path(JobId{5}), JobId{5}, before.record.submit.scenarios);
    MasterJob& job = state.jobs.add(MasterJob(std::move(before), Clock::now()));
    job.run->poses = poses();
    services.start.resume(job);
    run_until([&] { return job.work() != nullptr; });
    ASSERT_EQ(job.work()->todo.pieces().size(), 3u);
    EXPECT_EQ(job.work()->todo.pieces()[1].positions, (PositionRange{10, 5}));
    EXPECT_EQ(job.work()->todo.pieces()[1].losses.count(), 1u);
    EXPECT_THAT(job.run->losses_before, IsEmpty());
}

TEST_F(JobStartTest, AWorkerThatKeptBlocksOfTheTreesIsToldOfThem) {
    const std::vector<AddTree> trees = [this] {
        MasterJob& job = open();
        std::vector<AddTree> used = state.trees.messages();
        services.life.end(job, JobState::Cancelled, "cancelled");
        return used;
    }();
    const WorkerId keeper = join(70);
    const WorkerId other = join(71);
    desk.came(keeper, Holding{{trees.at(0).cut}});
    open();
    EXPECT_EQ(next<AddTree>(keeper).cut, trees.at(0).cut);
    EXPECT_THAT(received<AddTree>(other), IsEmpty());
}

} // namespace
} // namespace cd::tests
