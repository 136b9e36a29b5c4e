// Proves, with real processes and a network that does what networks do, that a job ends with the
// digest of one process and nothing is lost: connections cut, half open, slow, damaged, trickling
// or stalled; workers halted, killed, and back; the master killed among all that. What a broken
// connection interrupts is not done again when the worker is back in time.
#include "tests/cluster/faulty_proxy.hpp"
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/comes_true.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::HasSubstr;

/// A heartbeat that makes the tests short. No result hangs on it.
const std::vector<std::string> quick{"--heartbeat", "0.05"};

std::vector<std::string> quick_and(std::vector<std::string> more) {
    more.insert(more.begin(), quick.begin(), quick.end());
    return more;
}

/// Workers have all the time to come back: what is done again then, is by mistake.
class BrokenNetwork : public MortalCluster {
  protected:
    BrokenNetwork() : MortalCluster(quick_and({"--lost-after", "600", "--return-within", "600"})) {}

    /// One worker, behind the proxy, in the middle of a job.
    void start_job(std::uint64_t scenarios) {
        job_ = make_job(scenarios);
        start_worker_at(proxy_.address(), 2, {"--no-peers"});
        connection_ = connect();
        id_ = submit(*connection_, job_, Query{});
    }
    /// So many more, of which some are merged now.
    void progress(std::uint64_t more) {
        done_ = watch_until(*connection_, id_, done_ + more).summary.merged();
    }

    template <class Condition>
    ClusterStatus status_when(Condition condition) {
        const auto deadline = std::chrono::steady_clock::now() + patience;
        for (;;) {
            const auto status = connection_->status();
            EXPECT_TRUE(status) << status.error().detail;
            if (!status || condition(status.value())) {
                return status ? status.value() : ClusterStatus{};
            }
            if (std::chrono::steady_clock::now() > deadline) {
                ADD_FAILURE() << "this did not come: " << master_.log();
                return status.value();
            }
        }
    }
    void wait_for_state(WorkerState state) {
        status_when([&](const ClusterStatus& status) {
            return std::any_of(status.workers.begin(),
                               status.workers.end(),
                               [&](const WorkerStatus& worker) { return worker.state == state; });
        });
    }

    /// The end of the job, and that nothing of it was done again.
    void expect_right(bool nothing_again = true) {
        const JobStatus status = finish(*connection_, id_);
        EXPECT_EQ(status.state, JobState::Done) << status.failure;
        EXPECT_EQ(status.digest, job_.digest_in_one_process(Query{}));
        EXPECT_EQ(status.summary.failed, 0u);
        EXPECT_EQ(fetched(*connection_, status), job_.scenarios.size());
        const auto cluster = connection_->status();
        ASSERT_TRUE(cluster);
        EXPECT_EQ(cluster.value().alarm_count, 0u);
        std::printf("resumed %llu, lost %llu, scenarios given back %llu of %zu\n",
                    static_cast<unsigned long long>(cluster.value().sessions_resumed),
                    static_cast<unsigned long long>(cluster.value().workers_lost),
                    static_cast<unsigned long long>(cluster.value().scenarios_given_back),
                    job_.scenarios.size());
        if (nothing_again) {
            EXPECT_EQ(cluster.value().workers_lost, 0u);
            EXPECT_EQ(cluster.value().scenarios_given_back, 0u);
        }
        if (HasFailure()) {
            std::printf("%s\n", master_.log().c_str());
        }
    }
    [[nodiscard]] std::uint64_t resumed() {
        const auto status = connection_->status();
        return status ? status.value().sessions_resumed : 0;
    }

    FaultyProxy proxy_{master_.port()};
    Job job_;
    std::unique_ptr<Connection> connection_;
    JobId id_;
    std::uint64_t done_ = 0;
};

TEST_F(BrokenNetwork, ACutConnectionIsNotADeath) {
    start_job(3000);
    for (int cut = 0; cut < 8; ++cut) {
        progress(200);
        proxy_.cut();
    }
    expect_right();
    EXPECT_GE(resumed(), 5u);
}

TEST_F(BrokenNetwork, CutAgainBeforeItHasComeBackItComesBackAllTheSame) {
    start_job(2500);
    for (int burst = 0; burst < 4; ++burst) {
        progress(250);
        const std::uint64_t until = proxy_.connections() + 4;
        EXPECT_TRUE(comes_true([&] {
            proxy_.cut();
            return proxy_.connections() >= until;
        }));
    }
    expect_right();
}

TEST_F(BrokenNetwork, AHalfOpenConnectionIsNoticedAtBothEndsAndTheSessionGoesOn) {
    start_job(2000);
    for (int round = 0; round < 3; ++round) {
        progress(250);
        proxy_.set(Weather::Swallowed);
        const std::uint64_t before = proxy_.connections();
        const std::uint64_t swallowed = proxy_.swallowed();
        wait_for_state(WorkerState::Silent); // The master noticed.
        EXPECT_TRUE(comes_true([&] { return proxy_.swallowed() > swallowed; }));
        EXPECT_TRUE(comes_true([&] { return proxy_.connections() > before; }))
            << "the worker noticed";
        proxy_.set(Weather::Fair);
        wait_for_state(WorkerState::Alive);
    }
    expect_right();
    EXPECT_GE(resumed(), 3u);
}

TEST_F(BrokenNetwork, AConnectionThatStandsStillIsNoticedAndReplaced) {
    start_job(2000);
    for (int round = 0; round < 3; ++round) {
        progress(250);
        const std::uint64_t stalled = proxy_.stalled();
        proxy_.set(Weather::Stalled);
        EXPECT_TRUE(comes_true([&] { return proxy_.stalled() > stalled; }));
        wait_for_state(WorkerState::Silent);
        proxy_.set(Weather::Fair);
        wait_for_state(WorkerState::Alive);
    }
    expect_right();
}

TEST_F(BrokenNetwork, DelayOnlyCostsTime) {
    start_job(1500);
    proxy_.set(Weather::Delayed);
    progress(500);
    proxy_.set(Weather::Fair);
    EXPECT_GT(proxy_.delayed(), 0u);
    expect_right();
}

TEST_F(BrokenNetwork, ATrickleOnlyCostsTime) {
    start_job(2500);
    progress(300);
    proxy_.set(Weather::Trickling);
    progress(200);
    proxy_.set(Weather::Fair);
    EXPECT_GT(proxy_.trickled(), 0u);
    expect_right();
    EXPECT_EQ(resumed(), 0u) << "bytes come all the time";
}

TEST_F(BrokenNetwork, DamagedBytesAreNoticedAndChangeNothing) {
    start_job(3000);
    for (int round = 0; round < 10; ++round) {
        progress(150);
        const std::uint64_t before = proxy_.damaged();
        proxy_.damage(round % 2 == 0);
        EXPECT_TRUE(comes_true([&] { return proxy_.damaged() > before; }));
        status_when([&](const ClusterStatus& status) {
            return status.sessions_resumed > static_cast<std::uint64_t>(round);
        });
    }
    expect_right();
    EXPECT_EQ(proxy_.damaged(), 10u);
    EXPECT_GE(resumed(), 10u);
    EXPECT_THAT(master_.log(), HasSubstr("damaged frame"));
}

TEST_F(BrokenNetwork, AHaltedWorkerKeepsItsWork) {
    start_job(2500);
    for (int round = 0; round < 3; ++round) {
        progress(300);
        workers_[0]->signal(SIGSTOP);
        wait_for_state(WorkerState::Silent);
        workers_[0]->signal(SIGCONT);
        wait_for_state(WorkerState::Alive);
    }
    expect_right();
}

TEST_F(BrokenNetwork, WithTheMasterKilledInBetweenNothingIsLostEither) {
    start_job(2500);
    for (int round = 0; round < 3; ++round) {
        progress(250);
        proxy_.cut();
        connection_.reset();
        master_.kill();
        master_.start();
        connection_ = connect();
        const std::uint64_t swallowed = proxy_.swallowed();
        proxy_.set(Weather::Swallowed);
        EXPECT_TRUE(comes_true([&] { return proxy_.swallowed() > swallowed; }));
        proxy_.set(Weather::Fair);
        const std::uint64_t damaged = proxy_.damaged();
        proxy_.damage(true);
        EXPECT_TRUE(comes_true([&] { return proxy_.damaged() > damaged; }));
    }
    expect_right();
    EXPECT_EQ(proxy_.damaged(), 3u);
}

/// Workers that are not heard of are soon lost.
class LostWorkers : public BrokenNetwork {
  protected:
    LostWorkers() {
        master_.kill();
        master_.set_options(quick_and({"--lost-after", "0.3", "--return-within", "0.3"}));
        master_.start();
    }
};

TEST_F(LostWorkers, AWorkerThatIsLostGivesItsWorkBackAndMayReturn) {
    start_job(2500);
    progress(300);
    proxy_.set(Weather::Swallowed);
    wait_for_state(WorkerState::Lost);
    start_worker(1, {"--no-peers"});
    progress(300);
    proxy_.set(Weather::Fair);
    // What it had finished comes, too, and is merged once.
    status_when([&](const ClusterStatus& status) {
        return status.workers.size() == 2 &&
               std::none_of(status.workers.begin(), status.workers.end(), [](const auto& worker) {
                   return worker.state == WorkerState::Lost;
               });
    });
    expect_right(false);
    const auto status = connection_->status();
    ASSERT_TRUE(status);
    EXPECT_GE(status.value().workers_lost, 1u);
}

TEST_F(LostWorkers, HaltedForTooLongAWorkerIsLostAndItsLateResultsDoNoHarm) {
    start_job(2500);
    start_worker(1, {"--no-peers"});
    for (int round = 0; round < 2; ++round) {
        progress(250);
        workers_[0]->signal(SIGSTOP);
        wait_for_state(WorkerState::Lost);
        progress(300);
        workers_[0]->signal(SIGCONT);
        status_when([&](const ClusterStatus& status) { return status.workers.size() == 2; });
    }
    expect_right(false);
}

TEST_F(LostWorkers, AKilledWorkerIsReplacedAndTheStatusTellsOfIt) {
    start_job(2500);
    start_worker(1, {"--no-peers"});
    progress(300);
    workers_[0]->signal(SIGKILL);
    wait_for_state(WorkerState::Lost);
    const Ran told = run({program("cdctl").string(), "status", "--master", master_.address()});
    EXPECT_THAT(told.output, HasSubstr("lost"));
    expect_right(false);
}

} // namespace
} // namespace cd::tests
