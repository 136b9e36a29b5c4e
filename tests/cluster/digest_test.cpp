// Proves, with real processes over TCP, that the digest always equals that of one process: for any
// number of workers, strategy, distribution depth and buffer size, and when workers join late or
// are killed.
#include "common/job/result/packed_map.hpp"
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/cluster/mortal_master.hpp"

#include <algorithm>
#include <csignal>
#include <thread>
#include <utility>

namespace cd::tests {

namespace {

Query at_level(Level level) {
    Query query;
    query.level = level;
    return query;
}

} // namespace

TEST_F(Cluster, TheJobHasEveryKindOfScenario) {
    const Job job = make_job(600);
    start_worker(2);
    const JobStatus status = run(job, at_level(Level::Count));
    EXPECT_EQ(status.state, JobState::Done);
    EXPECT_TRUE(status.summary.is_complete());
    EXPECT_GT(status.summary.separate, 20u);
    EXPECT_GT(status.summary.cross, 100u);
    EXPECT_EQ(status.summary.failed, 0u);
    EXPECT_GT(status.answered_by_master, 0u);
    EXPECT_LT(status.answered_by_master, 600u);
}

TEST_F(Cluster, EveryLevelHasTheDigestOfOneProcess) {
    const Job job = make_job(300);
    start_worker(1);
    start_worker(2);
    for (const Level level : {Level::Any, Level::Count, Level::Pairs, Level::Contacts}) {
        const JobStatus status = run(job, at_level(level));
        EXPECT_EQ(status.digest, job.digest_in_one_process(at_level(level))) << to_text(level);
    }
    Query cut = at_level(Level::Pairs);
    cut.limit_pairs = 5;
    cut.ignored = {{0, 2000, 0, 700}};
    EXPECT_EQ(run(job, cut).digest, job.digest_in_one_process(cut));
}

// The far master listens at another address of this machine. The worker's own address differs from
// it, so both programs treat each other as programs of different hosts.
TEST_F(Cluster, ResultsArePackedOnlyBetweenHosts) {
    const Job job = make_job(200);
    const Query query = at_level(Level::Pairs);
    start_worker(1);
    const JobStatus within = run(job, query);
    const TemporaryFolder far_folder;
    const MortalMaster far_master(far_folder, {}, "127.0.0.2");
    const Process worker(worker_command(far_master.address(), "far", 1, {}), far_folder / "far");
    const auto connection = connect_to(far_master.address(), nullptr);
    const JobStatus between =
        finish_job(*connection, submit_job(*connection, job, query, many_blocks()));
    for (const JobStatus& status : {within, between}) {
        EXPECT_EQ(status.digest, job.digest_in_one_process(query));
    }
    EXPECT_LT(2 * between.traffic.result_bytes, within.traffic.result_bytes);
}

TEST_F(Cluster, ALimitKeepsTheFirstPairsAndTheirPoints) {
    const Job job = make_job(100);
    start_worker(2);
    Query query = at_level(Level::Contacts);
    const JobStatus whole = run(job, query);
    query.limit_pairs = 7;
    const JobStatus cut = run(job, query);
    EXPECT_EQ(cut.digest, job.digest_in_one_process(query));
    EXPECT_EQ(cut.summary.pairs, whole.summary.pairs);
    EXPECT_EQ(cut.summary.cross, whole.summary.cross);
    EXPECT_GT(cut.summary.cut, 10u);
    EXPECT_EQ(whole.summary.cut, 0u);
}

TEST_F(Cluster, StatisticsAreThoseOfTheWorkersTogether) {
    const Job job = make_job(200);
    start_worker(1);
    start_worker(1);
    const JobStatus status = run(job, at_level(Level::Count));
    const QueryStatistics& search = status.statistics.search;
    EXPECT_GT(search.box_tests, 0u);
    // Some stage settled every candidate: mostly the first, or the second if the first's batch had
    // too few.
    EXPECT_EQ(search.decisions.total(), search.triangle_tests);
    EXPECT_GT(search.decisions[PairStage::Float] + search.decisions[PairStage::Double],
              search.triangle_tests * 99 / 100);
    EXPECT_GT(search.decisions[PairStage::Float], search.triangle_tests / 2);
    // Both bodies are closed, so every scenario without contact was tested for `inside`.
    EXPECT_GE(status.statistics.inside.scenarios, status.summary.separate + status.summary.inside);
}

TEST_F(Cluster, TheNumberOfWorkersDoesNotChangeTheDigest) {
    const Job job = make_job(400);
    const Query query = at_level(Level::Pairs);
    const Sha256 expected = job.digest_in_one_process(query);
    for (const std::size_t workers : {1u, 2u, 5u}) {
        while (workers_.size() < workers) {
            start_worker();
        }
        EXPECT_EQ(run(job, query).digest, expected) << workers << " workers";
    }
}

TEST_F(Cluster, StrategyBufferAndClaimingDoNotChangeTheDigest) {
    const Job job = make_job(250);
    const Query query = at_level(Level::Pairs);
    const Sha256 expected = job.digest_in_one_process(query);
    start_worker();
    start_worker();
    for (const std::string_view strategy : strategy_names()) {
        for (const std::uint32_t q : {1u, 20u}) {
            for (const bool claim : {false, true}) {
                ClusterOptions options = many_blocks();
                options.strategy = strategy;
                options.q = q;
                options.claim = claim;
                EXPECT_EQ(run(job, query, options).digest, expected)
                    << strategy << ", q " << q << ", claim " << claim;
            }
        }
    }
}

TEST_F(Cluster, TheAnalysisModeDoesNotChangeTheDigest) {
    const Job job = make_job(1500);
    start_worker(1);
    start_worker(2);
    for (const Level level : {Level::Any, Level::Count, Level::Pairs}) {
        const Query query = at_level(level);
        const Sha256 expected = job.digest_in_one_process(query);
        for (const AnalysisMode mode :
             {AnalysisMode::Auto, AnalysisMode::Always, AnalysisMode::Never}) {
            ClusterOptions options = many_blocks();
            options.analysis = mode;
            const JobStatus status = run(job, query, options);
            EXPECT_EQ(status.digest, expected) << to_text(level) << ", " << to_text(mode);
            // The master answers scenarios without collisions only if it analyses.
            EXPECT_EQ(status.answered_by_master == 0, mode == AnalysisMode::Never);
        }
    }
}

TEST_F(Cluster, TheMapIsThatOfOneProcessThoughWorkersAreKilled) {
    const Job job = make_job(1500);
    Query query = at_level(Level::Count);
    query.maps = true;
    const Sha256 digest = job.digest_in_one_process(query);
    const ContactMap expected = job.map_in_one_process(query);
    ASSERT_GT(expected.bodies[0].size(), 100u);
    ASSERT_GT(expected.parts.pairs.size(), 10u);
    start_worker(1);
    start_worker(2);
    for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
        for (const std::string_view strategy : {"best-match", "earliest-finish"}) {
            ClusterOptions options;
            options.analysis = mode;
            options.strategy = strategy;
            Process& victim = start_worker();
            bool is_killed = false;
            const JobId id = submit(job, query, options);
            const JobStatus status = finish(id, [&](const JobStatus& now) {
                if (!is_killed && now.summary.merged() > now.answered_by_master + 100) {
                    victim.signal(SIGKILL);
                    is_killed = true;
                }
            });
            EXPECT_TRUE(is_killed);
            EXPECT_EQ(status.digest, digest);
            const auto answer = connection_->contact_map({id});
            ASSERT_TRUE(answer) << answer.error().detail;
            EXPECT_EQ(answer.value().withdrawn, "");
            const auto map = unpack_map(answer.value().map, any_map(1500));
            ASSERT_TRUE(map) << map.error().detail;
            EXPECT_EQ(map.value(), expected) << to_text(mode) << ", " << strategy;
            const auto parts = connection_->contact_map({id, true});
            ASSERT_TRUE(parts) << parts.error().detail;
            EXPECT_EQ(parts.value().map, pack_map({{}, expected.parts}));
        }
    }
    Query cut = at_level(Level::Pairs);
    cut.maps = true;
    cut.limit_pairs = 3;
    const JobId listed = submit(job, cut, {});
    EXPECT_EQ(finish(listed, [](auto&&...) {}).digest, job.digest_in_one_process(cut));
    const auto of_all = connection_->contact_map({listed});
    ASSERT_TRUE(of_all) << of_all.error().detail;
    const auto map_of_all = unpack_map(of_all.value().map, any_map(1500));
    ASSERT_TRUE(map_of_all) << map_of_all.error().detail;
    EXPECT_EQ(map_of_all.value().bodies, expected.bodies) << "also of the pairs that were cut";
    EXPECT_EQ(map_of_all.value().parts, job.map_in_one_process(cut).parts) << "of listed pairs";

    const JobId pairs = submit(job, at_level(Level::Pairs), {});
    finish(pairs, [](auto&&...) {});
    EXPECT_FALSE(connection_->contact_map({pairs}).value().is_asked);
    const auto summed = connection_->contact_map({pairs, true});
    ASSERT_TRUE(summed && summed.value().is_asked);
    EXPECT_EQ(summed.value().map, pack_map({{}, expected.parts})) << "all pairs are listed";

    const JobId plain = submit(job, at_level(Level::Count), {});
    EXPECT_EQ(finish(plain, [](auto&&...) {}).digest, digest);
    EXPECT_FALSE(connection_->contact_map({plain}).value().is_asked);
    EXPECT_FALSE(connection_->contact_map({plain, true}).value().is_asked);
}

TEST_F(Cluster, TheDistributionDepthDoesNotChangeTheDigest) {
    const Job job = make_job(200);
    const Query query = at_level(Level::Contacts);
    const Sha256 expected = job.digest_in_one_process(query);
    start_worker(2);
    for (std::uint32_t depth = 4; depth <= 14; ++depth) {
        ClusterOptions options;
        options.depths = {depth, 18 - depth};
        const JobStatus status = run(job, query, options);
        EXPECT_EQ(status.digest, expected) << "depth " << depth;
        EXPECT_EQ(status.depths, (std::vector<std::uint32_t>{depth, 18 - depth}));
    }
    const JobStatus chosen = run(job, query, {});
    EXPECT_EQ(chosen.digest, expected);
    // The bodies have 8,000 and 5,120 triangles.
    EXPECT_EQ(chosen.depths, (std::vector<std::uint32_t>{1, 0}));
}

TEST_F(Cluster, AWorkerThatJoinsInTheMiddleTakesItsShare) {
    const Job job = make_job(6000);
    const Query query = at_level(Level::Pairs);
    start_worker();
    const JobId id = submit(job, query, many_blocks());
    const JobStatus status = finish(id, [&](const JobStatus& now) {
        if (workers_.size() == 1 && now.summary.merged() > now.answered_by_master) {
            start_worker();
        }
    });
    EXPECT_EQ(status.digest, job.digest_in_one_process(query));
    ASSERT_EQ(workers_.size(), 2u);
    const auto cluster = connection_->status();
    ASSERT_TRUE(cluster) << cluster.error().detail;
    ASSERT_EQ(cluster.value().workers.size(), 2u);
    EXPECT_GT(cluster.value().workers[1].scenarios, 0u);
}

TEST_F(Cluster, AWorkerKilledInTheMiddleLosesNothing) {
    const Job job = make_job(6000);
    const Query query = at_level(Level::Pairs);
    const Sha256 expected = job.digest_in_one_process(query);
    start_worker();
    for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
        Process& victim = start_worker();
        ClusterOptions options = many_blocks();
        options.analysis = mode;
        const JobId id = submit(job, query, options);
        std::uint64_t merged_at_death = 0;
        const JobStatus status = finish(id, [&](const JobStatus& now) {
            if (merged_at_death == 0 && now.summary.merged() > now.answered_by_master) {
                victim.signal(SIGKILL);
                merged_at_death = now.summary.merged();
            }
        });
        EXPECT_EQ(status.state, JobState::Done);
        EXPECT_EQ(status.digest, expected) << to_text(mode);
        EXPECT_GT(merged_at_death, 0u);
        EXPECT_LT(merged_at_death, 6000u);
        EXPECT_EQ(victim.wait(), 128 + SIGKILL);
    }
}

TEST_F(Cluster, AJobOutlivesAllItsWorkers) {
    const Job job = make_job(4000);
    const Query query = at_level(Level::Count);
    Process& first = start_worker();
    const JobId id = submit(job, query, {});
    bool killed = false;
    const JobStatus status = finish(id, [&](const JobStatus& now) {
        if (!killed && now.summary.merged() > now.answered_by_master) {
            killed = true;
            first.signal(SIGKILL);
            start_worker();
        }
    });
    EXPECT_TRUE(killed);
    EXPECT_EQ(status.digest, job.digest_in_one_process(query));
}

TEST_F(Cluster, TwoClientsRunTwoJobsAtOnce) {
    const Job one = make_job(800);
    const Job two = make_job(500, 1.2);
    const Query query = at_level(Level::Pairs);
    start_worker();
    start_worker();
    const JobId first = submit(one, query, {});
    const std::unique_ptr<Connection> client_of_first = std::exchange(connection_, connect());
    const JobId second = submit(two, query, {});
    const JobStatus status_of_second = finish(second, [](const JobStatus&) {});
    const JobStatus status_of_first = finish(first, [](const JobStatus&) {});
    EXPECT_EQ(status_of_first.digest, one.digest_in_one_process(query));
    EXPECT_EQ(status_of_second.digest, two.digest_in_one_process(query));
}

TEST_F(Cluster, FetchedResultsAreThoseOfOneProcess) {
    const Job job = make_job(300);
    const Query query = at_level(Level::Contacts);
    start_worker();
    const JobId id = submit(job, query, {});
    ASSERT_EQ(finish(id, [](const JobStatus&) {}).state, JobState::Done);
    std::uint64_t next = 0;
    const Status fetched =
        connection_->fetch(id, 0, job.scenarios.size(), [&](const ScenarioResult& result) {
            EXPECT_EQ(
                encode_result(result),
                encode_result(run_scenario(*job.a, *job.b, job.scenarios[next], query).result));
            ++next;
            return Status(Done{});
        });
    EXPECT_TRUE(fetched) << fetched.error().detail;
    EXPECT_EQ(next, job.scenarios.size());
}

TEST_F(Cluster, AGridTravelsAsItsDescription) {
    Job job = make_job(1);
    Grid grid;
    grid.position[0] = {-2, 2, 9};
    grid.position[1] = {-1.5, 1.5, 4};
    grid.rotation[2] = rotation_axis({0, 300, 6}, 2);
    const auto source = make_grid_source(grid);
    job.scenarios = source->read(0, source->count()).value();
    start_worker();
    ASSERT_TRUE(submit(job, {}, {}).value != 0); // The master has the meshes now.

    Submit message;
    message.name = "grid";
    message.bodies = {{job.a->mesh().hash()}, {job.b->mesh().hash()}};
    message.scenarios = grid.count();
    message.grid = encode_grid(grid);
    message.poses.kind = PosesKind::Grid;
    const auto accepted = connection_->submit(message);
    ASSERT_TRUE(accepted) << accepted.error().detail;
    EXPECT_EQ(finish(accepted.value(), [](const JobStatus&) {}).digest,
              job.digest_in_one_process({}));
}

TEST_F(Cluster, SigtermEndsEveryProgramCleanly) {
    Process& worker = start_worker();
    const Job job = make_job(50);
    ASSERT_EQ(run(job, {}).state, JobState::Done);
    worker.signal(SIGTERM);
    EXPECT_EQ(worker.wait(), 0) << worker.errors();

    const TemporaryFolder state;
    Process master({program("cdmaster").string(),
                    "--listen",
                    "127.0.0.1:0",
                    "--port-file",
                    state / "port",
                    "--state",
                    state / "state"},
                   folder_ / "second_master");
    // The port file appears when the master listens; it handles signals before that.
    while (!std::filesystem::exists(state / "port") && master.is_running()) {
        std::this_thread::yield();
    }
    master.signal(SIGINT);
    EXPECT_EQ(master.wait(), 0) << master.errors();
}

TEST_F(Cluster, AWorkerWithAWrongSimdTargetSaysWhichThereAre) {
    for (const bool by_environment : {false, true}) {
        std::vector<std::string> command{program("cdworker").string(), "--simd", "abacus"};
        if (by_environment) {
            command = {"/usr/bin/env", "CD_SIMD=abacus", program("cdworker").string()};
        }
        const Ran ran = tests::run(command);
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_NE(ran.errors.find("there are auto"), std::string::npos) << ran.errors;
    }
}

TEST_F(Cluster, AWorkerWithoutAMasterSaysSoAndLeaves) {
    Process lost({program("cdworker").string(), "--master", "127.0.0.1:1", "--connect-for", "0"},
                 folder_ / "lost");
    EXPECT_EQ(lost.wait(), 4) << lost.errors();
    EXPECT_NE(lost.errors().find("127.0.0.1:1"), std::string::npos);
}

TEST_F(Cluster, NothingLeavesLoopbackUnasked) {
    for (const auto& command : std::vector<std::vector<std::string>>{
             {program("cdmaster").string(), "--listen", "0.0.0.0:0"},
             {program("cdworker").string(), "--master", "192.0.2.1:7600"},
             {program("cdctl").string(), "status", "--master", "192.0.2.1:7600"}}) {
        const Ran ran = tests::run(command);
        EXPECT_NE(ran.exit_code, 0) << command[0];
        EXPECT_NE(ran.errors.find("--insecure"), std::string::npos) << command[0] << ran.errors;
    }
}

} // namespace cd::tests
