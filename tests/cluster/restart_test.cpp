// Proves that a master killed at any moment loses nothing: restarted on its state it continues;
// workers return by themselves with their blocks and unacknowledged results; no finished scenario
// runs again; and the digest is that of one process.
#include "common/core/limits/engine.hpp"
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/comes_true.hpp"
#include "web/status/job_id.hpp"

#include <sys/resource.h>

#include <csignal>
#include <functional>
#include <map>
#include <set>
#include <thread>

namespace cd::tests {
namespace {

class Restart : public MortalCluster {
  protected:
    /// Starts `cdctl watch` and `cdctl wait`, and waits until each says that the job is paused,
    /// with `text`.
    std::vector<std::unique_ptr<Process>> follow_until_told(const std::string& text) {
        std::vector<std::unique_ptr<Process>> followers;
        for (const char* verb : {"watch", "wait"}) {
            followers.push_back(std::make_unique<Process>(
                std::vector<std::string>{cdctl(), verb, "last", "--master", master_.address()},
                folder_ / verb));
        }
        for (const auto& follower : followers) {
            EXPECT_TRUE(comes_true([&] {
                const std::string told = follower->errors();
                return told.find("  paused: ") != std::string::npos &&
                       told.find(text) != std::string::npos;
            })) << follower->errors();
        }
        return followers;
    }

    /// Submits a job to a new worker, and waits until so many scenarios are merged.
    JobId begin(Connection& connection, const Job& job, std::uint64_t merged) {
        start_worker();
        const JobId id = submit(connection, job, Query{});
        (void)watch_until(connection, id, merged);
        return id;
    }
};

TEST_F(Restart, AJobGoesOnHoweverOftenTheMasterIsKilled) {
    const Job job = make_job(6000);
    const Query query;
    start_worker();
    start_worker();
    auto connection = connect();
    const JobId id = submit(*connection, job, query);
    std::uint64_t before = 0;
    int killed = 0;
    for (const std::uint64_t point : {1u, 1200u, 2500u, 4000u, 5500u}) {
        const JobStatus status = watch_until(*connection, id, point);
        if (status.state != JobState::Running) {
            break;
        }
        EXPECT_GE(status.summary.merged(), before);
        restart_master(connection);
        ++killed;
        const auto now = connection->status();
        ASSERT_TRUE(now);
        ASSERT_EQ(now.value().jobs.size(), 1u);
        EXPECT_EQ(now.value().jobs[0].job, id);
        before = now.value().jobs[0].summary.merged();
    }
    EXPECT_GE(killed, 3);
    const JobStatus status = finish(*connection, id);
    EXPECT_EQ(status.state, JobState::Done) << status.failure;
    EXPECT_EQ(status.digest, job.digest_in_one_process(query));
    EXPECT_EQ(fetched(*connection, status), 6000u);
    EXPECT_TRUE(workers_[0]->is_running());
    EXPECT_TRUE(workers_[1]->is_running());
}

/// Returns the number of blocks the master has sent, by worker name.
std::map<std::string, std::uint64_t> blocks_sent(const ClusterStatus& status) {
    std::map<std::string, std::uint64_t> sent;
    for (const WorkerStatus& worker : status.workers) {
        sent[worker.name] = worker.subtrees_sent;
    }
    return sent;
}

TEST_F(Restart, FinishedScenariosDoNotRunAgainAndBlocksAreNotSentAgain) {
    const Job job = make_job(4000);
    const Query query;
    start_worker(1, {"--no-peers"});
    start_worker(1, {"--no-peers"});
    auto connection = connect();
    const JobId id = submit(*connection, job, query);
    const JobStatus before = watch_until(*connection, id, 3000);
    ASSERT_EQ(before.state, JobState::Running);
    const auto at_death = connection->status();
    ASSERT_TRUE(at_death);
    restart_master(connection);
    const JobStatus status = finish(*connection, id);
    EXPECT_EQ(status.digest, job.digest_in_one_process(query));
    const auto cluster = connection->status();
    ASSERT_TRUE(cluster);
    ASSERT_EQ(cluster.value().workers.size(), 2u);
    // Including those sent before the restart, no worker got more blocks than exist.
    auto sent = blocks_sent(cluster.value());
    const std::uint64_t blocks_there = cut_tree(*job.a, status.depths.at(0)).root_count() +
                                       cut_tree(*job.b, status.depths.at(1)).root_count() +
                                       2; // The upper trees.
    for (const auto& [name, blocks] : blocks_sent(at_death.value())) {
        EXPECT_GT(blocks, blocks_there * 3 / 4) << "then this shows little";
        // Blocks in flight when the master died must be sent again.
        EXPECT_LE(blocks + sent.at(name), blocks_there + blocks_there / 20);
    }
    std::uint64_t answered = 0;
    for (const WorkerStatus& worker : cluster.value().workers) {
        answered += worker.scenarios;
    }
    // Merged scenarios are on disk, except those of the last few commits. The workers may meanwhile
    // have received and done the rest.
    EXPECT_LE(answered, 4000 - 3000 + 600u);
    // Counters continue across the restart.
    EXPECT_GE(status.traffic.result_bytes, before.traffic.result_bytes);
    EXPECT_GE(status.traffic.blocks.master_bytes, before.traffic.blocks.master_bytes);
    EXPECT_GT(before.traffic.blocks.master_bytes, 0u);
    // The job has ended: explain names the author of the answer, without scores.
    const auto explained = connection->explain(id, 0);
    ASSERT_TRUE(explained) << explained.error().detail;
    EXPECT_NE(explained.value().where.find("answered"), std::string::npos);
    EXPECT_NE(explained.value().note.find("has ended"), std::string::npos);
    EXPECT_TRUE(explained.value().workers.empty());
}

/// The two analysis modes need different blocks: one needs the upper trees.
class RestartWithFullCaches : public Restart, public testing::WithParamInterface<AnalysisMode> {};

TEST_P(RestartWithFullCaches, NotOneByteOfABlockIsSentAgain) {
    // In one pose all scenarios touch the same blocks: after one answer a worker has them all.
    Job job = make_job(3000);
    for (Scenario& scenario : job.scenarios) {
        scenario.poses = {translation_pose(0, 0, 0), translation_pose(1.2, 0, 0)};
    }
    start_worker(1, {"--no-peers"});
    start_worker(1, {"--no-peers"});
    auto connection = connect();
    ASSERT_TRUE(comes_true([&] {
        const auto status = connection->status();
        return status && status.value().workers.size() == 2;
    }));
    ClusterOptions options = many_blocks();
    options.analysis = GetParam();
    const JobId id = submit(*connection, job, Query{}, options);
    ClusterStatus before;
    ASSERT_TRUE(comes_true([&] {
        const auto status = connection->status();
        before = status ? status.value() : ClusterStatus{};
        return before.workers.size() == 2 && before.workers[0].scenarios > 0 &&
               before.workers[1].scenarios > 0;
    }));
    ASSERT_EQ(before.jobs.at(0).state, JobState::Running);
    restart_master(connection);
    const JobStatus status = finish(*connection, id);
    EXPECT_EQ(status.state, JobState::Done) << status.failure;
    EXPECT_EQ(status.digest, job.digest_in_one_process(Query{}));
    EXPECT_EQ(status.traffic.blocks.evictions, 0u);
    const auto sent = blocks_sent(before);
    EXPECT_GT(sent.at("worker0"), 100u) << "then this shows little";
    EXPECT_EQ(sent.at("worker0"), sent.at("worker1"));
    // Over both incarnations, each block reaches each worker at most once.
    std::uint64_t bytes = 0;
    for (const WorkerStatus& worker : before.workers) {
        bytes += worker.subtree_bytes_sent;
    }
    EXPECT_LE(status.traffic.blocks.master_bytes, bytes);

    const auto cluster = connection->status();
    ASSERT_TRUE(cluster);
    ASSERT_EQ(cluster.value().workers.size(), 2u);
    std::uint64_t answered = 0;
    for (const WorkerStatus& worker : cluster.value().workers) {
        EXPECT_EQ(worker.subtrees_sent, 0u) << worker.name;
        EXPECT_EQ(worker.subtree_bytes_sent, 0u) << worker.name;
        answered += worker.scenarios;
    }
    EXPECT_GT(answered, 100u) << "then this shows little";
}

INSTANTIATE_TEST_SUITE_P(Analysis,
                         RestartWithFullCaches,
                         testing::Values(AnalysisMode::Always, AnalysisMode::Never),
                         [](const auto& mode) {
                             return mode.param == AnalysisMode::Always ? "ByTheMaster"
                                                                       : "ByWorkers";
                         });

/// Runs a function before the poses from one position on are read.
class InterruptedPoses final : public PoseSource {
  public:
    InterruptedPoses(std::vector<Scenario> scenarios,
                     std::uint64_t place,
                     std::function<void()> action)
        : all_(make_list_source(std::move(scenarios))), place_(place), action_(std::move(action)) {}

    [[nodiscard]] std::uint64_t count() const override { return all_->count(); }
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override {
        if (first <= place_ && place_ < first + count) {
            action_();
        }
        return all_->read(first, count);
    }

  private:
    std::unique_ptr<PoseSource> all_;
    std::uint64_t place_;
    std::function<void()> action_;
};

TEST_F(Restart, KilledWhileAJobIsSubmittedItKnowsTheJobOrNothing) {
    constexpr std::uint64_t scenarios = 9000;
    const Job job = make_job(scenarios);
    std::vector<Scenario> two_windows = job.scenarios;
    while (two_windows.size() < limits::order_window_scenarios + 1000) {
        two_windows.push_back(two_windows[two_windows.size() - scenarios]);
        two_windows.back().index = two_windows.size() - 1;
    }
    const std::vector<NamedMesh> meshes{{"a", job.a->mesh_pointer()}, {"b", job.b->mesh_pointer()}};
    Submit message;
    message.bodies = {{job.a->mesh().hash()}, {job.b->mesh().hash()}};
    std::set<JobId> promised;
    // Kills at the start and in the middle of an upload; before the first poses; when a window of
    // poses was sent and the next is read; and right after the job is accepted.
    for (const int moment : {0, 1, 2, 3, 4}) {
        auto connection = connect();
        int pieces = 0;
        const Status uploaded = connection->upload(meshes, [&](auto&&...) {
            if (moment < 2 && pieces++ == moment) {
                master_.kill();
            }
        });
        EXPECT_EQ(bool(uploaded), moment >= 2);
        if (uploaded) {
            const auto& sent = moment == 3 ? two_windows : job.scenarios;
            const std::uint64_t place = moment == 2 ? 0 : moment == 3 ? sent.size() - 1 : scenarios;
            InterruptedPoses poses(sent, place, [&] { master_.kill(); });
            const auto accepted = connection->submit(message, poses);
            EXPECT_EQ(bool(accepted), moment == 4);
            if (accepted) {
                promised.insert(accepted.value());
                master_.kill();
            }
        }
        master_.start();
        const auto status = connect()->status();
        ASSERT_TRUE(status) << status.error().detail;
        std::set<JobId> known;
        for (const JobStatus& each : status.value().jobs) {
            EXPECT_EQ(each.summary.total, scenarios);
            known.insert(each.job);
        }
        EXPECT_EQ(known, promised);
    }
    start_worker(2);
    auto connection = connect();
    for (const JobId id : promised) {
        EXPECT_EQ(finish(*connection, id).digest, job.digest_in_one_process(Query{}));
    }
}

TEST_F(Restart, AJobWhoseEndAClientHeardOfStaysEnded) {
    const Job job = make_job(300);
    start_worker();
    auto connection = connect();
    for (int round = 0; round < 3; ++round) {
        const JobId id = submit(*connection, job, Query{});
        const JobStatus ended = finish(*connection, id);
        ASSERT_EQ(ended.state, JobState::Done);
        restart_master(connection);
        const JobStatus again = finish(*connection, id);
        EXPECT_EQ(again.state, JobState::Done);
        EXPECT_EQ(again.digest, ended.digest);
        EXPECT_EQ(again.summary.pairs, ended.summary.pairs);
        EXPECT_EQ(fetched(*connection, again), 300u);
    }
}

TEST_F(Restart, ACancelledJobStaysCancelled) {
    auto connection = connect();
    const JobId id = submit(*connection, make_job(100), Query{});
    ASSERT_EQ(connection->cancel(id).value().state, JobState::Cancelled);
    restart_master(connection);
    EXPECT_EQ(finish(*connection, id).state, JobState::Cancelled);
}

TEST_F(Restart, WorkersLeftAloneKeepTheirResultsForTheNextMaster) {
    const Job job = make_job(3000);
    Process& worker = start_worker();
    auto connection = connect();
    const JobId id = submit(*connection, job, Query{});
    (void)watch_until(*connection, id, 500);
    connection.reset();
    // The worker is stopped with tasks; the master is gone when it continues.
    worker.signal(SIGSTOP);
    master_.kill();
    worker.signal(SIGCONT);
    master_.start();
    connection = connect();
    const JobStatus status = finish(*connection, id);
    EXPECT_EQ(status.digest, job.digest_in_one_process(Query{}));
}

/// The workers have finished all their tasks and return one after the other.
TEST_F(Restart, ResultsOfWorkersThatReturnAreNotComputedAgain) {
    constexpr std::uint64_t scenarios = 40000;
    const Job job = make_job(scenarios);
    for (int i = 0; i < 3; ++i) {
        start_worker();
    }
    auto connection = connect();
    Query query;
    query.level = Level::Any;
    const JobId id = submit(*connection, job, query);
    // After a restart, the master waits only for workers with results in the journal. The journal
    // commits every few milliseconds. So the test waits until each worker has given results, and
    // then for 2000 more, by which time the first ones are in the journal.
    std::uint64_t merged = 0;
    ASSERT_TRUE(comes_true([&] {
        const ClusterStatus status = connection->status().value();
        merged = status.jobs.at(0).summary.merged();
        return std::ranges::all_of(status.workers,
                                   [](const WorkerStatus& worker) { return worker.scenarios > 0; });
    }));
    ASSERT_EQ(watch_until(*connection, id, merged + 2000).state, JobState::Running);
    connection.reset();
    master_.kill();
    const auto attempts = [](const Process& worker) {
        const std::string log = worker.errors();
        std::size_t count = 0;
        for (std::size_t at = 0; (at = log.find("no master yet", at + 1)) != std::string::npos;) {
            ++count;
        }
        return count;
    };
    ASSERT_TRUE(comes_true([&] {
        return std::ranges::all_of(workers_,
                                   [&](const auto& worker) { return attempts(*worker) >= 5; });
    }));
    master_.start();
    connection = connect();
    const JobStatus status = finish(*connection, id);
    EXPECT_EQ(status.digest, job.digest_in_one_process(query));
    std::uint64_t computed = status.answered_by_master;
    for (const auto& worker : workers_) {
        worker->signal(SIGTERM);
        EXPECT_EQ(worker->wait(), 0);
        const std::string log = worker->errors();
        computed += std::stoull(log.substr(log.rfind("scenarios_computed=") + 19));
    }
    EXPECT_GE(computed, scenarios);
    // Usually no scenario runs twice; 7 to 10 % would if the master did not wait for the workers.
    // Speculative copies are for stragglers.
    EXPECT_LE(computed, scenarios + scenarios / 100 + status.copies);
}

TEST_F(Restart, WithoutItsStateDirectoryAJobIsPausedUntilThatIsBack) {
    const Job job = make_job(4000);
    auto connection = connect();
    const JobId id = begin(*connection, job, 500);
    std::filesystem::rename(folder_ / "state", folder_ / "elsewhere");
    EXPECT_TRUE(comes_true([&] {
        const auto now = connection->status();
        return now && now.value().jobs.at(0).paused.find("was removed") != std::string::npos;
    }));
    EXPECT_NE(master_.log().find("was removed"), std::string::npos);
    EXPECT_EQ(connection->status().value().jobs.at(0).state, JobState::Running);
    std::filesystem::rename(folder_ / "elsewhere", folder_ / "state");
    const JobStatus status = finish(*connection, id);
    EXPECT_EQ(status.state, JobState::Done);
    EXPECT_EQ(status.digest, job.digest_in_one_process(Query{}));
}

/// Limits the size of files a process writes, as a full disk does.
void limit_files(const Process& process, rlim_t bytes) {
    rlimit limit{};
    ASSERT_EQ(::prlimit(process.id(), RLIMIT_FSIZE, nullptr, &limit), 0);
    limit.rlim_cur = bytes;
    ASSERT_EQ(::prlimit(process.id(), RLIMIT_FSIZE, &limit, nullptr), 0);
}

TEST_F(Restart, WithAFullDiskJobsWaitVisiblyAndGoOnWhenThereIsRoom) {
    const Job job = make_job(4000);
    auto connection = connect();
    const JobId id = begin(*connection, job, 500);
    limit_files(master_.process(), 64 << 10);
    JobStatus status;
    ASSERT_TRUE(comes_true([&] {
        status = connection->status().value().jobs.at(0);
        return !status.paused.empty();
    }));
    EXPECT_EQ(status.state, JobState::Running);
    const Ran told = run({program("cdctl").string(), "status", "--master", master_.address()});
    EXPECT_NE(told.output.find("paused"), std::string::npos) << told.output;
    auto followers = follow_until_told("  paused: ");
    write_obj(folder_ / "big.obj", make_torus(2, 1, 200, 150));
    const std::string big = folder_ / "big.obj";
    const Ran upload = run({cdctl(),
                            "run",
                            "-q",
                            "--a",
                            big,
                            "--b",
                            big,
                            "--random",
                            "1",
                            "--master",
                            master_.address()});
    EXPECT_EQ(upload.exit_code, 3);
    EXPECT_EQ(upload.errors,
              "cdctl: the master has no room for big.obj (1.4 MiB): its disk is full or cannot be "
              "written; its log says why\n");
    Submit another;
    another.bodies = {{job.a->mesh().hash()}, {job.b->mesh().hash()}};
    const auto poses = make_list_source(job.scenarios);
    EXPECT_FALSE(connect()->submit(another, *poses)) << "what cannot be kept is not accepted";
    limit_files(master_.process(), RLIM_INFINITY);
    status = finish(*connection, id);
    EXPECT_EQ(status.state, JobState::Done);
    EXPECT_EQ(status.digest, job.digest_in_one_process(Query{}));
    EXPECT_EQ(fetched(*connection, status), 4000u);
    for (const auto& follower : followers) {
        EXPECT_EQ(follower->wait(), 0) << follower->errors();
    }
}

TEST_F(Restart, WithADamagedMeshAJobWaitsAndItsFollowersAreToldForWhichFile) {
    const Job job = make_job(2000);
    auto connection = connect();
    const JobId id = begin(*connection, job, 500);
    connection.reset();
    master_.kill();
    // Without what was made of it, the mesh is read again.
    std::filesystem::remove_all(folder_ / "state/trees");
    std::filesystem::remove_all(folder_ / "state/blocks");
    const std::string mesh = folder_ / ("state/meshes/" + to_hex(job.a->mesh().hash()) + ".mesh");
    const std::string good = read_text(mesh);
    ASSERT_GT(good.size(), 1000u);
    std::string bad = good;
    bad[1000] = static_cast<char>(bad[1000] ^ 1);
    write_text(mesh, bad);
    master_.start();
    auto followers = follow_until_told(to_hex(job.a->mesh().hash()) + ".mesh");
    write_text(mesh, good);
    for (const auto& follower : followers) {
        EXPECT_EQ(follower->wait(patience), 0) << follower->errors();
    }
    EXPECT_EQ(finish(*connect(), id).digest, job.digest_in_one_process(Query{}));
}

TEST_F(Restart, ADamagedStateIsNamedNotUsedAndNotChanged) {
    const Job job = make_job(2000);
    auto connection = connect();
    const JobId id = begin(*connection, job, 1000);
    connection.reset();
    // On SIGTERM the master writes all merged results to disk. Killed at once, it could have
    // written none of them.
    master_.process().signal(SIGTERM);
    EXPECT_EQ(master_.process().wait(), 0);
    master_.start();
    master_.kill();
    const std::vector<std::string> check{
        program("cdmaster").string(), "check", "--state", (folder_ / "state").string()};
    const Ran sound = run(check);
    EXPECT_EQ(sound.exit_code, 0) << sound.output << sound.errors;
    EXPECT_NE(sound.output.find("1 jobs, 1 of them unfinished"), std::string::npos) << sound.output;

    const auto results = folder_ / "state/jobs/1.results";
    const std::string good = read_text(results);
    std::string bad = good;
    bad[1000] = static_cast<char>(bad[1000] ^ 1);
    write_text(results, bad);
    const Ran damaged = run(check);
    EXPECT_EQ(damaged.exit_code, 2);
    EXPECT_NE(damaged.output.find("1.results"), std::string::npos) << damaged.output;
    const std::vector<std::string> start{program("cdmaster").string(),
                                         "--listen",
                                         "127.0.0.1:0",
                                         "--state",
                                         (folder_ / "state").string()};
    const Ran refused = run(start);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.errors.find("1.results"), std::string::npos) << refused.errors;
    EXPECT_NE(refused.errors.find("restore the state directory"), std::string::npos)
        << refused.errors;
    EXPECT_EQ(read_text(results), bad);

    write_text(results, good);
    const auto poses = folder_ / "state/jobs/1.poses";
    std::filesystem::rename(poses, folder_ / "away");
    const Ran without = run(start);
    EXPECT_EQ(without.exit_code, 2);
    EXPECT_NE(without.errors.find("1.poses"), std::string::npos) << without.errors;
    EXPECT_NE(without.errors.find("restore the state directory"), std::string::npos)
        << without.errors;
    std::filesystem::rename(folder_ / "away", poses);
    master_.start();
    connection = connect();
    EXPECT_EQ(finish(*connection, id).digest, job.digest_in_one_process(Query{}));
}

TEST_F(Restart, TheStateOfAKilledMasterIsCheckedOnAReadOnlyDisk) {
    const std::string state = folder_ / "state";
    const std::string mounted =
        "mount --bind " + state + " " + state + " && mount -o remount,ro,bind " + state + " && ";
    if (run({"/usr/bin/env", "unshare", "-m", "sh", "-c", mounted + "true"}).exit_code != 0) {
        GTEST_SKIP() << "no file system can be mounted here";
    }
    auto connection = connect();
    (void)submit(*connection, make_job(20), Query{});
    connection.reset();
    master_.kill();
    ASSERT_GT(std::filesystem::file_size(folder_ / "state/journal.db-wal"), 0u);
    const std::string check = program("cdmaster").string() + " check --state " + state;
    const Ran checked = run({"/usr/bin/env", "unshare", "-m", "sh", "-c", mounted + check});
    EXPECT_EQ(checked.exit_code, 0) << checked.output << checked.errors;
    EXPECT_NE(checked.output.find("1 jobs, 1 of them unfinished"), std::string::npos)
        << checked.output;
    EXPECT_NE(checked.output.find("the state is sound"), std::string::npos) << checked.output;
}

TEST_F(Restart, CdctlWaitsForAMasterThatComesBack) {
    const Job job = make_job(3000);
    auto connection = connect();
    const JobId id = submit(*connection, job, Query{});
    Process waiting(
        {program("cdctl").string(), "wait", job_id_text(id), "--master", master_.address()},
        folder_ / "wait");
    start_worker();
    (void)watch_until(*connection, id, 800);
    connection.reset();
    master_.kill();
    master_.start();
    EXPECT_EQ(waiting.wait(), 0) << waiting.errors();
    EXPECT_EQ(finish(*connect(), id).digest, job.digest_in_one_process(Query{}));
}

TEST_F(Restart, ASecondMasterOnTheSameStateIsRefused) {
    const Ran second = run({program("cdmaster").string(),
                            "--listen",
                            "127.0.0.1:0",
                            "--state",
                            (folder_ / "state").string()});
    EXPECT_EQ(second.exit_code, 2);
    EXPECT_NE(second.errors.find("in use by another process"), std::string::npos) << second.errors;
    EXPECT_TRUE(connect()->status());
}

} // namespace
} // namespace cd::tests
