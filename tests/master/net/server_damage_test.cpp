// Proves that a file damaged while a job runs fails neither the job nor anything else: the job
// waits, names the file, and resumes once it is mended.
#include "common/core/limits/master.hpp"
#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/master/master_stage.hpp"

#include <latch>

namespace cd::tests {
namespace {

/// Flips a bit of a file until it is mended.
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
        : Master({.return_within = std::chrono::milliseconds(0)}, {}, stage) {
        Client client(*this);
        Submit submit = reference().submission();
        submit.cluster.analysis = mode;
        client.start_submitting(submit);
        run_until([&] { return client.done; });
        job = client.job.value();
    }

    [[nodiscard]] std::filesystem::path poses() const { return journal->poses_path(job); }
    [[nodiscard]] JobStatus status() { return coordinator.jobs().status(job).value(); }

    void expect_to_wait_for(const Damage& damage) {
        run_until([&] { return !status().paused.empty(); });
        EXPECT_NE(status().paused.find(damage.name()), std::string::npos) << status().paused;
        EXPECT_EQ(status().state, JobState::Running);
        EXPECT_EQ(coordinator.jobs().cluster().jobs.at(0).paused, status().paused);
    }

    /// Runs until the results with which the only worker came are read and checked.
    void finish_checks_of_results() {
        run_until([&] {
            const auto workers = coordinator.jobs().cluster().workers;
            return !workers.empty() && workers[0].cached_bytes == FakeWorker::cached_bytes;
        });
        // When all threads meet, what was posted before has ended.
        const auto all_meet = std::make_shared<std::latch>(blocking.size() + 1);
        for (unsigned thread = 0; thread < blocking.size(); ++thread) {
            blocking.post([all_meet] { all_meet->arrive_and_wait(); });
        }
        all_meet->arrive_and_wait();
        context.poll();
    }

    void expect_right_end() {
        run_until([&] { return status().state != JobState::Running; });
        EXPECT_EQ(status().state, JobState::Done) << status().failure;
        EXPECT_EQ(status().digest, reference().digest);
        EXPECT_TRUE(status().paused.empty());
    }

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
    {
        Client client(master);
        client.start_asking({Cancel{master.job, std::nullopt}});
        master.run_until([&] { return client.done; });
    }
    EXPECT_EQ(master.status().state, JobState::Cancelled);
    EXPECT_TRUE(master.status().paused.empty());
    master.end();
    EXPECT_TRUE(master.context.stopped());
}

TEST(ServerDamage, DamagedBlocksDoNotPauseAJob) {
    DamagedMaster master(AnalysisMode::Never);
    master.run_until(
        [&] { return master.coordinator.jobs().explainer().input(master.job).has_value(); });
    std::vector<Damage> damages;
    for (const auto& entry : std::filesystem::directory_iterator(master.directory / "blocks")) {
        damages.emplace_back(entry.path());
    }
    ASSERT_EQ(damages.size(), 2u);
    const FakeWorker worker(master, {});
    master.expect_right_end();
}

TEST(ServerDamage, ADisputeWaitsForThePosesToJudgeIt) {
    DamagedMaster master(AnalysisMode::Never);
    master.run_until(
        [&] { return master.coordinator.jobs().explainer().input(master.job).has_value(); });
    std::latch released(1);
    for (unsigned thread = 0; thread < master.blocking.size(); ++thread) {
        master.blocking.post([&] { released.wait(); }); // Blocks the master's runs.
    }
    {
        const FakeWorker liar(master, {.lies_second = true, .batches_max = 1});
        master.run_until([&] { return liar.kept == 2; });
    }
    const Damage damage(master.poses());
    released.count_down();
    master.expect_to_wait_for(damage);
    EXPECT_EQ(master.coordinator.alarms().record().count, 0u);
    damage.mend();
    const FakeWorker good(master, {});
    master.expect_right_end();
    EXPECT_GT(master.coordinator.alarms().record().count, 0u);
}

TEST(ServerDamage, ResultsOfAWaitingJobBlockNoOther) {
    DamagedMaster master(AnalysisMode::Always);
    const Damage damage(master.poses());
    const std::vector<Results> all = more_than_fit_in_hand(master.job);
    const FakeWorker worker(master, {.comes_with = all});
    master.expect_to_wait_for(damage);
    Client client(master);
    client.start(reference().submission());
    master.run_until([&] { return client.done; });
    expect_right(client);
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
