// Proves, with real processes and a faulty network, that a job ends with the digest of one process
// and nothing is lost: connections are cut, half open, slow, damaged, trickling or stalled; workers
// are stopped, killed and return; the master is killed meanwhile. Work that a broken connection
// interrupts is not repeated if the worker returns in time.
#include "tests/cluster/broken_network.hpp"
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/support/comes_true.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::HasSubstr;

TEST_F(BrokenNetwork, ASessionGoesOnAfterItsConnectionIsCut) {
    start_job(3000);
    for (int cut = 0; cut < 8; ++cut) {
        progress(200);
        proxy_.cut();
    }
    expect_right();
    EXPECT_GE(resumed(), 5u);
}

TEST_F(BrokenNetwork, ASessionGoesOnOverALongLineThatBreaks) {
    proxy_.set_delay(std::chrono::milliseconds(25));
    proxy_.set(Weather::Delayed);
    start_job(3000);
    for (int cut = 0; cut < 4; ++cut) {
        progress(200);
        proxy_.cut();
    }
    expect_right();
    EXPECT_GE(resumed(), 3u);
    EXPECT_GT(proxy_.delayed(), 0u);
}

TEST_F(BrokenNetwork, ASessionGoesOnAfterCutsDuringItsReconnection) {
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
    EXPECT_TRUE(comes_true([&] { return proxy_.delayed() > 0; }));
    progress(500);
    proxy_.set(Weather::Fair);
    expect_right();
}

TEST_F(BrokenNetwork, ATrickleOnlyCostsTime) {
    start_job(2500);
    progress(300);
    proxy_.set(Weather::Trickling);
    EXPECT_TRUE(comes_true([&] { return proxy_.trickled() > 0; }));
    progress(200);
    proxy_.set(Weather::Fair);
    expect_right();
}

TEST_F(BrokenNetwork, DamagedBytesAreNoticedAndChangeNothing) {
    start_job(3000);
    for (int round = 0; round < 10; ++round) {
        progress(150);
        const std::uint64_t before = proxy_.damaged();
        proxy_.damage(round % 2 == 0);
        EXPECT_TRUE(comes_true([&] { return proxy_.damaged() > before; }));
        status_when([&](const ClusterStatus& status) {
            return status.losses.sessions_resumed > static_cast<std::uint64_t>(round);
        });
    }
    expect_right();
    EXPECT_EQ(proxy_.damaged(), 10u);
    EXPECT_GE(resumed(), 10u);
    EXPECT_THAT(master_.log(), HasSubstr("damaged frame"));
}

TEST_F(BrokenNetwork, AWorkerThatIsDrainedWhileItIsAwayEndsWhenItIsBack) {
    start_job(3000);
    progress(200);
    proxy_.set(Weather::Swallowed);
    wait_for_state(WorkerState::Silent);
    ASSERT_TRUE(connection_->drain(DrainWorkers{}));
    proxy_.set(Weather::Fair);
    EXPECT_EQ(workers_[0]->wait(patience), 0) << workers_[0]->errors();
    start_worker_at(proxy_.address(), 2, {"--no-peers"});
    expect_right();
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

TEST_F(BrokenNetwork, CutsAndRestartsOfTheMasterLoseNothing) {
    start_job(2500);
    for (int round = 0; round < 3; ++round) {
        progress(250);
        proxy_.cut();
        connection_.reset();
        master_.kill();
        // Before the master is back. Else it may receive a Hello whose Welcome is swallowed, and
        // the worker begins another session.
        const std::uint64_t swallowed = proxy_.swallowed();
        proxy_.set(Weather::Swallowed);
        master_.start();
        connection_ = connect();
        EXPECT_TRUE(comes_true([&] { return proxy_.swallowed() > swallowed; }));
        proxy_.set(Weather::Fair);
        const std::uint64_t damaged = proxy_.damaged();
        proxy_.damage(true);
        EXPECT_TRUE(comes_true([&] { return proxy_.damaged() > damaged; }));
    }
    expect_right();
    EXPECT_EQ(proxy_.damaged(), 3u);
}

/// Declares silent workers lost after a short time.
class LostWorkers : public BrokenNetwork {
  protected:
    LostWorkers() {
        master_.kill();
        master_.set_options(
            {"--heartbeat", quick_heartbeat, "--lost-after", "0.3", "--return-within", "0.3"});
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
    // The worker's finished results arrive, too, and are merged once.
    status_when([&](const ClusterStatus& status) {
        return status.workers.size() == 2 &&
               std::none_of(status.workers.begin(), status.workers.end(), [](const auto& worker) {
                   return worker.state == WorkerState::Lost;
               });
    });
    expect_right(false);
    const auto status = connection_->status();
    ASSERT_TRUE(status);
    EXPECT_GE(status.value().losses.workers_lost, 1u);
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
    const Ran told = run({cdctl(), "status", "--master", master_.address()});
    EXPECT_THAT(told.output, HasSubstr("lost"));
    expect_right(false);

    // Only one of the two listed meshes is present.
    write_obj(folder_ / "box.obj", make_box({1, 1, 1}));
    const std::string box = folder_ / "box.obj";
    const Ran next = run(
        {cdctl(), "run", "--a", box, "--b", box, "--random", "3", "--master", master_.address()});
    EXPECT_EQ(next.exit_code, 0) << next.errors;
    EXPECT_THAT(next.errors, testing::StartsWith("  on " + master_.address() + ", 1 worker\n"));
}

TEST_F(LostWorkers, AKilledWorkerIsNamedToWatchersOfTheJob) {
    connection_ = connect();
    job_ = make_long_job(1, 9);
    start_worker(1, {"--no-peers"});
    start_worker(1, {"--no-peers"});
    ClusterOptions one_block;
    one_block.depths = {0, 0};
    id_ = submit(*connection_, job_, Query{}, one_block);
    status_when([&](const ClusterStatus& status) { return status.workers.size() == 2; });
    Process watch({cdctl(), "watch", "last", "--master", master_.address()}, folder_ / "watch");
    workers_[0]->signal(SIGKILL);
    EXPECT_TRUE(comes_true([&] {
        return watch.errors().find("  lost: worker0; others do the work\n") != std::string::npos;
    })) << watch.errors();
    ASSERT_TRUE(connection_->cancel(id_));
    EXPECT_EQ(watch.wait(), 3) << watch.errors();
}

} // namespace
} // namespace cd::tests
