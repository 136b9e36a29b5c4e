// Proves what a job's end frees, that a job without all results or with a dispute does not end, and
// that a job waits for the disk while a step of it waits.
#include "master/jobs/job_life.hpp"

#include "tests/master/parts_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Error disk_full{ErrorCode::Io, "no space"};

class JobLifeTest : public PartsStage {
  protected:
    /// A step that waits for the disk; counts its repetitions.
    void wait(MasterJob& job, const Error& why = disk_full) {
        life_.wait_for_disk(
            job, why, [this](MasterJob* again) { again == nullptr ? ++given_up_ : ++repeated_; });
    }
    void merge_all(MasterJob& job) {
        for (const Scenario& scenario : reference().scenarios) {
            merge(job, right_result(scenario.index), 70);
        }
    }

    std::vector<JobId> ending_; ///< Jobs that still run, but no longer for long.
    int retried_ = 0;
    int repeated_ = 0;
    int given_up_ = 0;
    JobLife life_{{state.jobs,
                   state.workers,
                   state.trees,
                   state.blocks,
                   state.dispatch,
                   state.writer,
                   state.retries},
                  {[this](JobId job) {
                       EXPECT_TRUE(state.jobs.at(job).is_running());
                       ending_.push_back(job);
                   },
                   [this] { ++retried_; }}};
};

TEST_F(JobLifeTest, AnEndFreesWhatWorkersHaveOfTheJob) {
    const WorkerId worker = join(70);
    MasterJob& job = open();
    services.work.feed();
    next<WorkUnit>(worker);
    life_.end(job, JobState::Cancelled, "cancelled");
    EXPECT_THAT(ending_, ElementsAre(job.id));
    EXPECT_FALSE(job.is_running());
    EXPECT_THAT(state.trees.messages(), IsEmpty());
    EXPECT_EQ(state.dispatch.view().unanswered(job.id), 0u);
    EXPECT_EQ(next<RemoveJob>(worker).job, job.id);
    next<RemoveTree>(worker, 1); // The second of two.
    run_until([&] { return !ended.empty(); });
    EXPECT_THAT(ended, ElementsAre(job.id));
}

TEST_F(JobLifeTest, TreesOfAnotherJobStay) {
    MasterJob& job = open();
    MasterJob& other = open();
    EXPECT_EQ(job.work()->trees, other.work()->trees);
    life_.end(job, JobState::Cancelled, "cancelled");
    EXPECT_EQ(state.trees.messages().size(), 2u);
    life_.end(other, JobState::Cancelled, "cancelled");
    EXPECT_THAT(state.trees.messages(), IsEmpty());
}

TEST_F(JobLifeTest, AJobEndsWhenItHasAllResultsAndNoDispute) {
    MasterJob& job = open();
    life_.end_if_complete(job);
    EXPECT_TRUE(job.is_running()) << "it has no results";
    merge_all(job);
    job.run->disputes = 1;
    life_.end_if_complete(job);
    EXPECT_TRUE(job.is_running()) << "it has a dispute";
    job.run->disputes = 0;
    life_.end_if_complete(job);
    ASSERT_FALSE(job.is_running());
    EXPECT_EQ(job.end->state, JobState::Done);
    EXPECT_EQ(job.end->digest, reference().digest);
    life_.end_if_complete(job); // The job has ended.
}

TEST_F(JobLifeTest, AStepThatFailsOnTheDiskPausesTheJobAndIsRepeated) {
    MasterJob& job = open();
    wait(job);
    EXPECT_EQ(job.run->paused, "no space");
    EXPECT_TRUE(life_.is_waiting(job.id));
    life_.disk_gives(job);
    EXPECT_EQ(job.run->paused, "no space") << "a step of it still waits";
    run_until([&] { return repeated_ == 1; });
    EXPECT_EQ(retried_, 1);
    EXPECT_FALSE(life_.is_waiting(job.id));
    life_.disk_gives(job);
    EXPECT_EQ(job.run->paused, "");
}

TEST_F(JobLifeTest, AnErrorThatIsNotTheDisksFailsTheJob) {
    MasterJob& job = open();
    wait(job, {ErrorCode::TooLarge, "a mesh is too large"});
    EXPECT_EQ(given_up_, 1);
    ASSERT_FALSE(job.is_running());
    EXPECT_EQ(job.end->state, JobState::Failed);
    EXPECT_EQ(job.end->failure, "a mesh is too large");
}

TEST_F(JobLifeTest, AStepOfAJobThatEndsIsGivenUp) {
    MasterJob& job = open();
    wait(job);
    life_.end(job, JobState::Cancelled, "cancelled");
    EXPECT_FALSE(life_.is_waiting(job.id));
    run_until([&] { return given_up_ == 1; });
    EXPECT_EQ(repeated_, 0);
}

} // namespace
} // namespace cd::tests
