// Proves what clients may ask of a job in each of its phases, and what is refused.
#include "master/coordinator/job_desk.hpp"

#include "common/job/result/packed_map.hpp"
#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

#include <span>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class JobDeskTest : public PartsStage {
  protected:
    /// Ends the job, which its client hears of.
    void end(MasterJob& job, JobState state_at_end = JobState::Cancelled) {
        services.life.end(job, state_at_end, "");
        run_until([this] { return !ended.empty(); });
        (void)state.jobs.announce(job);
    }

    JobDesk jobs_{state, services, stored};
};

TEST_F(JobDeskTest, AnIdIsAllottedOnceAndMayBeGivenUp) {
    const JobId first = jobs_.allot(10).value();
    jobs_.give_up(first);
    EXPECT_NE(jobs_.allot(10).value(), first);
    EXPECT_EQ(jobs_.find(first), nullptr);
    EXPECT_EQ(jobs_.status(first).error().code, ErrorCode::NotFound);
}

TEST_F(JobDeskTest, ACancelledJobEndsOnce) {
    MasterJob& job = open();
    EXPECT_EQ(jobs_.cancel(job.id).value().state, JobState::Running) << "until that is durable";
    EXPECT_EQ(job.end->state, JobState::Cancelled);
    const std::uint64_t at = job.end->ended;
    EXPECT_TRUE(jobs_.cancel(job.id));
    EXPECT_EQ(job.end->ended, at);
    EXPECT_EQ(jobs_.cancel(JobId{99}).error().code, ErrorCode::NotFound);
    run_until([this] { return !ended.empty(); });
    EXPECT_THAT(ended, ElementsAre(job.id));
}

TEST_F(JobDeskTest, ANewPriorityIsThatOfTheJobItsWorkAndItsRecord) {
    MasterJob& low = open();
    MasterJob& job = begin(submission(AnalysisMode::Always));
    EXPECT_TRUE(jobs_.set_priority(job.id, 2)) << "its geometry is not there yet";
    run_until([&] { return job.work() != nullptr; });
    const auto is_first = [&] { return state.dispatch.view().is_analysed_before(job.id, low.id); };
    EXPECT_TRUE(is_first());
    const std::uint64_t changes = job.changes;
    const std::uint64_t position = jobs_.set_priority(job.id, -2).value();
    EXPECT_FALSE(is_first());
    EXPECT_FALSE(jobs_.is_durable(position));
    EXPECT_EQ(jobs_.status(job.id).value().turn.priority, -2);
    EXPECT_GT(job.changes, changes);
    run_until([&] { return jobs_.is_durable(position); });
    const JobRecord record = journal->job(job.id).value();
    EXPECT_EQ(record.submit.priority, -2);
    EXPECT_EQ(record.submit.scenarios, job.submit.scenarios);
}

TEST_F(JobDeskTest, ThePriorityOfAnEndedJobStays) {
    MasterJob& job = open();
    services.life.end(job, JobState::Cancelled, "");
    EXPECT_EQ(jobs_.set_priority(job.id, 2).error().code, ErrorCode::Refused);
    EXPECT_EQ(jobs_.set_priority(JobId{99}, 2).error().code, ErrorCode::NotFound);
    EXPECT_EQ(job.submit.priority, 0);
}

TEST_F(JobDeskTest, OnlyAnEndedJobIsForgotten) {
    MasterJob& job = open();
    const JobId id = job.id;
    EXPECT_EQ(jobs_.forget(id).error().code, ErrorCode::Refused);
    end(job);
    EXPECT_TRUE(jobs_.forget(id));
    EXPECT_EQ(jobs_.find(id), nullptr);
    EXPECT_EQ(jobs_.forget(id).error().code, ErrorCode::NotFound);
    EXPECT_THAT(dropped, IsEmpty()) << "the journal still has it";
    run_until([this] { return !dropped.empty(); });
    EXPECT_THAT(dropped, ElementsAre(id));
}

TEST_F(JobDeskTest, AJobIsForgottenWhenItsRetentionIsOver) {
    Submit submit = submission(AnalysisMode::Always);
    submit.retention_seconds = 60;
    MasterJob& job = open(submit);
    const JobId id = job.id;
    end(job);
    const std::uint64_t at = job.end->ended;
    jobs_.forget_expired(at + 60);
    EXPECT_NE(jobs_.find(id), nullptr);
    jobs_.forget_expired(at + 61);
    EXPECT_EQ(jobs_.find(id), nullptr);
    run_until([this] { return !dropped.empty(); });
}

TEST_F(JobDeskTest, WhileTheJournalCannotWriteNoJobBeginsOrIsForgotten) {
    Submit submit = submission(AnalysisMode::Always);
    submit.retention_seconds = 60;
    MasterJob& past = open(submit);
    const JobId id = past.id;
    end(past);
    MasterJob& running = open();
    const std::uint64_t expired = past.end->ended + 61;
    const std::filesystem::path elsewhere = folder.path().string() + "_away";
    std::filesystem::rename(folder.path(), elsewhere);
    merge(running, right_result(5), 70);
    run_until([this] { return !jobs_.paused().empty(); });

    EXPECT_EQ(jobs_.allot(10).error().code, ErrorCode::Io);
    EXPECT_EQ(jobs_.forget(id).error().code, ErrorCode::Io);
    EXPECT_EQ(jobs_.set_priority(running.id, 2).error().code, ErrorCode::Io);
    jobs_.forget_expired(expired);
    EXPECT_NE(jobs_.find(id), nullptr);
    EXPECT_EQ(jobs_.cluster().jobs.size(), 2u) << "questions are still answered";

    std::filesystem::rename(elsewhere, folder.path());
    run_until([this] { return jobs_.paused().empty(); });
    EXPECT_TRUE(jobs_.allot(10));
    jobs_.forget_expired(expired);
    EXPECT_EQ(jobs_.find(id), nullptr);
    run_until([this] { return !dropped.empty(); });
}

TEST_F(JobDeskTest, AnUnansweredScenarioIsCancelledOnAllWorkers) {
    const WorkerId worker = join(70);
    MasterJob& job = open();
    services.work.feed();
    next<AddJob>(worker);
    const std::uint64_t index = scenario_with_contact();
    const PlacedScenario scenario = placed(job, index);
    ASSERT_TRUE(job.work()->open.has(scenario.position));
    EXPECT_TRUE(jobs_.cancel_scenario(job.id, scenario));
    EXPECT_TRUE(job.merged.is_failed_by_master(index));
    EXPECT_FALSE(job.work()->open.has(scenario.position));
    EXPECT_EQ(received<DropScenario>(worker).at(0).scenario, index);
    EXPECT_EQ(jobs_.cancel_scenario(job.id, scenario).error().code, ErrorCode::Refused);
}

TEST_F(JobDeskTest, PosesAreToldOnlyOfAScenarioWithoutAResult) {
    MasterJob& job = open();
    EXPECT_EQ(jobs_.poses_of_unanswered(job.id, 5).value(), job.run->poses);
    EXPECT_EQ(jobs_.poses_of_unanswered(job.id, 90).error().code, ErrorCode::NotFound);
    EXPECT_EQ(jobs_.poses_of_unanswered(JobId{99}, 5).error().code, ErrorCode::NotFound);
    merge(job, right_result(5), 70);
    EXPECT_EQ(jobs_.poses_of_unanswered(job.id, 5).error().code, ErrorCode::Refused);
    services.life.end(job, JobState::Cancelled, "");
    EXPECT_EQ(jobs_.poses_of_unanswered(job.id, 6).error().code, ErrorCode::Refused);
}

TEST_F(JobDeskTest, ADisputedScenarioIsCancelledWhileTheMasterRunsIt) {
    MasterJob& job = open();
    EXPECT_FALSE(jobs_.cancel_disputed(job.id, 5));
    services.references.start(
        job.id, 5, job.work()->material, job.run->poses, [](Result<ReferenceResult>) {});
    EXPECT_FALSE(jobs_.cancel_disputed(job.id, 6));
    EXPECT_TRUE(jobs_.cancel_disputed(job.id, 5));
}

TEST_F(JobDeskTest, OnlyADoneJobHasAMap) {
    MasterJob& job = open();
    EXPECT_EQ(jobs_.contact_map({job.id}).error().code, ErrorCode::Refused);
    EXPECT_EQ(jobs_.contact_map({JobId{99}}).error().code, ErrorCode::NotFound);
    EXPECT_EQ(jobs_.contact_map({JobId{99}, true}).error().code, ErrorCode::NotFound);
    for (const Scenario& scenario : reference().scenarios) {
        merge(job, right_result(scenario.index), 70);
    }
    end(job, JobState::Done);
    EXPECT_EQ(jobs_.contact_map({job.id}).value().job, job.id);
}

TEST_F(JobDeskTest, ARunningJobHasTheSumsByPartOfItsResultsSoFar) {
    Submit submit = submission(AnalysisMode::Always);
    submit.query.maps = true;
    MasterJob& job = open(submit);
    const std::uint64_t scenario = scenario_with_contact();
    const ContactMap map =
        reference_map(*job.work()->material, *job.run->poses, std::span(&scenario, 1)).value();
    ASSERT_FALSE(map.parts.empty());
    job.map.add(map);
    const auto sums = [&] {
        const ContactMapAnswer answer = jobs_.contact_map({job.id, true}).value();
        EXPECT_TRUE(answer.is_asked);
        return unpack_map(answer.map, any_map()).value();
    };
    EXPECT_EQ(sums(), (ContactMap{{}, map.parts}));
    services.life.end(job, JobState::Cancelled, "");
    EXPECT_EQ(sums(), (ContactMap{{}, map.parts})) << "also when it has ended";
    MasterJob& wrong = open(submit);
    wrong.map.add(map);
    wrong.map.withdraw("a worker was wrong");
    EXPECT_TRUE(jobs_.contact_map({wrong.id, true}).value().map.empty());
    EXPECT_EQ(jobs_.contact_map({wrong.id, true}).value().withdrawn, "a worker was wrong");
}

TEST_F(JobDeskTest, TheClusterHasItsWorkersJobsAndMeshes) {
    join(70);
    open();
    const ClusterStatus cluster = jobs_.cluster();
    EXPECT_EQ(cluster.workers.size(), 1u);
    EXPECT_EQ(cluster.jobs.size(), 1u);
    EXPECT_EQ(cluster.meshes.size(), 2u);
}

} // namespace
} // namespace cd::tests
