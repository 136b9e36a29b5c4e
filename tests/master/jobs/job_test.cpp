// Proves a job's phases: it runs without work, then with work, then it has ended; and that a job
// from before a restart goes on where it was.
#include "master/jobs/job.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

constexpr Clock::time_point start{};

Submit submit(std::uint64_t scenarios) {
    Submit submit;
    submit.name = "wheel in arch";
    submit.scenarios = scenarios;
    submit.query.ignored = {{1, 2, 3, 4}};
    return submit;
}

MasterJob new_job(std::uint64_t scenarios = 2) {
    return {JobId{7}, submit(scenarios), nullptr, start};
}

TEST(MasterJob, RunsWithoutWorkUntilItsGeometryIsLoaded) {
    const MasterJob job = new_job();
    EXPECT_TRUE(job.is_running());
    EXPECT_EQ(job.work(), nullptr);
    const JobStatus status = job.status(start + 3s);
    EXPECT_EQ(status.job, JobId{7});
    EXPECT_EQ(status.state, JobState::Running);
    EXPECT_EQ(status.name, "wheel in arch");
    EXPECT_EQ(status.summary.total, 2u);
    EXPECT_DOUBLE_EQ(status.seconds, 3);
}

TEST(MasterJob, RunsWithWorkOnceItsGeometryIsLoaded) {
    MasterJob job = new_job();
    job.run->work = std::make_unique<JobWork>();
    EXPECT_EQ(job.work(), job.run->work.get());
    EXPECT_EQ(job.work()->analyses_under_way(), 0u) << "no analyser is made yet";
}

TEST(MasterJob, EndsWithADigestWhenItIsDone) {
    MasterJob job = new_job();
    job.run->work = std::make_unique<JobWork>();
    for (std::uint64_t index = 0; index < 2; ++index) {
        (void)job.merged.add(index, {}, Sha256{}, nullptr);
    }
    const auto digest = job.merged.digest();
    job.finish(JobState::Done, "", start + 4s);
    EXPECT_FALSE(job.is_running());
    EXPECT_EQ(job.work(), nullptr);
    EXPECT_EQ(job.end->digest, digest);
    EXPECT_TRUE(job.submit.query.ignored.empty()) << "an ended job has no bulk";
    EXPECT_DOUBLE_EQ(job.status(start + 9s).seconds, 4) << "its time stands still";
}

TEST(MasterJob, ShowsItsEndOnlyWhenThatIsAnnounced) {
    MasterJob job = new_job();
    job.finish(JobState::Failed, "no room", start);
    EXPECT_EQ(job.state(), JobState::Running);
    EXPECT_EQ(job.status(start).failure, "");
    job.is_announced = true;
    EXPECT_EQ(job.state(), JobState::Failed);
    EXPECT_EQ(job.status(start).failure, "no room");
    EXPECT_FALSE(job.status(start).digest.has_value());
}

TEST(MasterJob, ShowsWhyItIsPaused) {
    MasterJob job = new_job();
    job.run->paused = "no space";
    EXPECT_EQ(job.status(start).paused, "no space");
    job.finish(JobState::Cancelled, "cancelled", start);
    EXPECT_EQ(job.status(start).paused, "");
}

RecoveredJob recovered() {
    RecoveredJob before;
    before.record = {JobId{7}, submit(2), 1000};
    before.merger = ResultMerger(2);
    (void)before.merger.add(0, {}, Sha256{});
    before.progress.seconds = 5;
    before.progress.answered_by_master = 6;
    before.progress.help = {1, 2, 3};
    before.progress.statistics.search.effort = {9, 5, 12, 3};
    before.progress.depths = {4, 3};
    before.withdrawn = 8;
    before.losses = {{{0, 1}, 70}};
    return before;
}

TEST(MasterJob, GoesOnAfterARestartOfTheMaster) {
    const MasterJob job(recovered(), start);
    EXPECT_TRUE(job.is_running());
    EXPECT_EQ(job.work(), nullptr);
    EXPECT_EQ(job.run->losses_before, (std::vector<LostPositions>{{{0, 1}, 70}}));
    const JobStatus status = job.status(start + 2s);
    EXPECT_DOUBLE_EQ(status.seconds, 7) << "of both incarnations";
    EXPECT_EQ(status.summary.merged(), 1u);
    EXPECT_EQ(status.answered_by_master, 6u);
    EXPECT_EQ(status.withdrawn, 8u);
    EXPECT_EQ(status.copies_won, 3u);
    EXPECT_EQ(status.statistics.search.effort, (SearchEffort{9, 5, 12, 3}));
    EXPECT_EQ(status.began, 1000u);
    EXPECT_EQ(job.progress(start).depths, (std::vector<std::uint32_t>{4, 3}));
}

TEST(MasterJob, ThatEndedBeforeARestartIsEnded) {
    RecoveredJob before = recovered();
    before.end = JobEnd{JobState::Cancelled, "cancelled", {}, 2000};
    before.contributors = {70, 71};
    const MasterJob job(std::move(before), start);
    EXPECT_FALSE(job.is_running());
    EXPECT_EQ(job.state(), JobState::Cancelled);
    EXPECT_EQ(job.status(start).failure, "cancelled");
    EXPECT_EQ(job.merged.processes(), (std::set<InstanceId>{70, 71}));
    EXPECT_TRUE(job.submit.query.ignored.empty());
    EXPECT_DOUBLE_EQ(job.status(start + 9s).seconds, 5);
}

} // namespace
} // namespace cd::tests
