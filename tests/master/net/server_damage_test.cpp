// Proves that a file damaged while a job runs fails neither the job nor anything else: the job
// waits, names the file, and resumes once it is mended.
#include "common/core/limits/master.hpp"
#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/master/master_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::HasSubstr;

/// Flips a bit of many bytes of a file until it is mended.
class Damage {
  public:
    explicit Damage(std::filesystem::path path) : path_(std::move(path)), whole_(read_text(path_)) {
        std::string damaged = whole_;
        for (std::size_t i = damaged.size() / 2; i < damaged.size(); i += 16) {
            damaged[i] = static_cast<char>(damaged[i] ^ 1);
        }
        write_text(path_, damaged);
    }
    void mend() const { write_text(path_, whole_); }
    [[nodiscard]] std::string name() const { return path_.filename(); }

  private:
    std::filesystem::path path_;
    std::string whole_;
};

/// A master with a job that is accepted but not prepared.
class DamagedMaster : public Master {
  public:
    explicit DamagedMaster(AnalysisMode mode, const Stage& stage = {})
        : Master(no_return, {}, stage), job(submit_to(*this, submission(mode))) {}

    [[nodiscard]] std::filesystem::path poses() const { return journal->poses_path(job); }
    [[nodiscard]] JobStatus status() { return Master::status(job); }

    void expect_to_wait_for(const Damage& damage) {
        run_until([&] { return !status().paused.empty(); });
        EXPECT_THAT(status().paused, HasSubstr(damage.name()));
        EXPECT_EQ(status().state, JobState::Running);
        EXPECT_EQ(cluster().jobs.at(0).paused, status().paused);
    }

    /// Runs until the results with which the only worker came are read and checked.
    void finish_checks_of_results() {
        run_until([&] {
            const auto workers = cluster().workers;
            return !workers.empty() && workers[0].cached_bytes == FakeWorker::cached_bytes;
        });
        wait_for_all(blocking);
        context.poll();
    }

    void expect_right_end() { tests::expect_right_end(*this, job); }

    JobId job;
};

std::vector<Results> more_than_fit_in_hand(JobId job) {
    std::vector<Results> all;
    for (std::uint64_t i = 0; i < 2 * limits::results_in_hand_max; ++i) {
        all.push_back(right_results(job, i));
    }
    return all;
}

TEST(ServerDamage, PosesThatCannotBeReadAreWaitedFor) {
    for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
        DamagedMaster master(mode);
        const Damage damage(master.poses());
        const FakeWorker worker(master, {});
        master.expect_to_wait_for(damage);
        damage.mend();
        master.expect_right_end();
    }
}

TEST(ServerDamage, AJobThatWaitsForItsPosesMayBeCancelledAndTheMasterEnded) {
    DamagedMaster master(AnalysisMode::Always);
    const Damage damage(master.poses());
    master.expect_to_wait_for(damage);
    (void)answer_to(master, {Cancel{master.job, std::nullopt}});
    EXPECT_EQ(master.status().state, JobState::Cancelled);
    EXPECT_TRUE(master.status().paused.empty());
    master.end();
    EXPECT_TRUE(master.context.stopped());
}

TEST(ServerDamage, DamagedBlocksDoNotPauseAJob) {
    DamagedMaster master(AnalysisMode::Never);
    master.run_until_prepared(master.job);
    std::vector<Damage> damages;
    for (const auto& entry : std::filesystem::directory_iterator(master.directory / "blocks")) {
        damages.emplace_back(entry.path());
    }
    ASSERT_EQ(damages.size(), 2u);
    const FakeWorker worker(master, {});
    master.expect_right_end();
}

TEST(ServerDamage, ResultsOfAWaitingJobBlockNoOther) {
    DamagedMaster master(AnalysisMode::Always);
    const Damage damage(master.poses());
    const std::vector<Results> all = more_than_fit_in_hand(master.job);
    const FakeWorker worker(master, {.comes_with = all});
    master.expect_to_wait_for(damage);
    Client(master, reference().submission()).expect_right();
    EXPECT_EQ(master.status().state, JobState::Running);
    damage.mend();
    master.expect_right_end();
}

TEST(ServerDamage, ResultsBeyondTheParkingLimitAreReadOneByOne) {
    DamagedMaster master(AnalysisMode::Always, {.results_aside_bytes_max = 0});
    const Damage damage(master.poses());
    const std::vector<Results> all = more_than_fit_in_hand(master.job);
    const FakeWorker worker(master, {.comes_with = all});
    master.expect_to_wait_for(damage);
    EXPECT_EQ(worker.kept, 0u);
    damage.mend();
    master.run_until([&] { return worker.kept_of_before == all.size(); });
    master.expect_right_end();
}

/// Results repeat over one connection, and over the next.
TEST(ServerDamage, RepeatedUncheckableResultsAreParkedOnce) {
    DamagedMaster master(AnalysisMode::Always);
    const Damage damage(master.poses());
    Results twice = right_results(master.job, 0);
    twice.sequence = 1;
    const FakeWorker worker(master, {.comes_with = {twice, twice, twice}});
    master.expect_to_wait_for(damage);
    master.finish_checks_of_results();
    damage.mend();
    master.run_until([&] { return worker.kept_of_before != 0; });
    master.expect_right_end();
    EXPECT_EQ(worker.kept_of_before, 1u);
}

/// Results come as from an earlier session, so the master must read their poses.
TEST(ServerDamage, UnreadablePosesCutNoWorkerOff) {
    DamagedMaster master(AnalysisMode::Always);
    const Damage damage(master.poses());
    const FakeWorker worker(master,
                            {.comes_with = {right_results(master.job, scenario_with_contact())}});
    master.expect_to_wait_for(damage);
    EXPECT_EQ(worker.kept, 0u);
    damage.mend();
    master.run_until([&] { return worker.kept != 0; });
    master.expect_right_end();
    EXPECT_FALSE(worker.ended);
}

} // namespace
} // namespace cd::tests
