// Proves, with real processes over TCP, that jobs one after the other on the same bodies send each
// block of geometry to a worker once, whatever else differs between the jobs, as long as the caches
// have room; and that caches without room change no answer.
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/comes_true.hpp"
#include "tests/support/scenarios.hpp"

namespace cd::tests {

namespace {

/// Every worker gets scenarios, and nothing is requested for scenarios that it then does not get.
ClusterOptions everywhere(AnalysisMode analysis) {
    ClusterOptions options;
    options.depths = {4, 3};
    options.strategy = "random";
    options.q = 4;
    options.hints = false;
    options.analysis = analysis;
    return options;
}

/// Number of blocks of the job's bodies at these depths, with the two upper trees.
std::uint64_t blocks_of(const Job& job, const ClusterOptions& options) {
    return cut_nodes(*job.a, *options.depth(0)).size() +
           cut_nodes(*job.b, *options.depth(1)).size() + 2;
}

std::uint64_t bytes_of(const JobStatus& status) {
    return status.traffic.blocks.master_bytes + status.traffic.blocks.peer_bytes;
}

/// Makes a job of other bodies than those of `make_job`, of about the same size.
Job make_other_job(std::uint64_t count) {
    ThreadPool pool(2);
    Job job;
    job.a = std::make_shared<const ObbTree>(
        build_tree(share(make_torus(1.1, 0.35, 100, 40)), {}, pool));
    job.b = std::make_shared<const ObbTree>(
        build_tree(share(make_gridded_box(Vec3(0.8, 0.7, 0.9), 20)), {}, pool));
    job.scenarios = mixed_scenarios(count, 1.6);
    return job;
}

class Series : public Cluster {
  protected:
    JobStatus run_right(const Job& job, const Query& query, const ClusterOptions& options) {
        const JobStatus status = run(job, query, options);
        EXPECT_EQ(status.state, JobState::Done) << status.failure;
        EXPECT_EQ(status.digest, job.digest_in_one_process(query));
        return status;
    }
};

class SeriesRestart : public MortalCluster {};

} // namespace

TEST_F(Series, OtherPosesAndLevelsGetNoBlockTwice) {
    constexpr std::uint64_t workers = 3;
    for (std::uint64_t i = 0; i < workers; ++i) {
        start_worker();
    }
    Job job = make_job(200);
    BlockTraffic sum;
    std::uint64_t blocks = 0;
    for (const AnalysisMode analysis : {AnalysisMode::Always, AnalysisMode::Never}) {
        for (const Level level : levels) {
            job.scenarios = mixed_scenarios(job.scenarios.size() + 20, 1.6);
            const ClusterOptions options = everywhere(analysis);
            sum += run_right(job, query_of(level), options).traffic.blocks;
            blocks = blocks_of(job, options);
        }
    }
    EXPECT_GT(sum.hits, 0u);
    EXPECT_GE(sum.misses, blocks);
    EXPECT_LE(sum.misses, workers * blocks);
    EXPECT_EQ(sum.evictions, 0u);
}

TEST_F(Series, TheSameJobAgainGetsNothingAtAll) {
    start_worker(2);
    const Job job = make_job(200);
    const Query query = query_of(Level::Pairs);
    ClusterOptions options;
    EXPECT_GT(bytes_of(run_right(job, query, options)), 0u);
    options.analysis = AnalysisMode::Never; // The upper trees may still be missing.
    (void)run_right(job, query, options);
    for (const AnalysisMode analysis : {AnalysisMode::Always, AnalysisMode::Never}) {
        options.analysis = analysis;
        EXPECT_EQ(bytes_of(run_right(job, query, options)), 0u) << to_text(analysis);
    }
}

TEST_F(Series, ANewWorkerGetsTheBlocksFromThoseThatKeptThem) {
    start_worker();
    const Job job = make_job(200);
    const Query query = query_of(Level::Count);
    const ClusterOptions options = everywhere(AnalysisMode::Never);
    (void)run_right(job, query, options);
    start_worker();
    ASSERT_TRUE(comes_true([&] { return connection_->status().value().workers.size() == 2; }));
    const JobStatus status = run_right(job, query, options);
    EXPECT_EQ(status.traffic.blocks.master_bytes, 0u);
    EXPECT_GT(status.traffic.blocks.peer_bytes, 0u);
}

TEST_F(SeriesRestart, BlocksOutliveTheMaster) {
    start_worker();
    const Job job = make_job(200);
    const Query query = query_of(Level::Count);
    const ClusterOptions options = everywhere(AnalysisMode::Never);
    auto connection = connect();
    EXPECT_GT(bytes_of(finish(*connection, submit(*connection, job, query, options))), 0u);
    restart_master(connection);
    const JobStatus status = finish(*connection, submit(*connection, job, query, options));
    EXPECT_EQ(status.digest, job.digest_in_one_process(query));
    EXPECT_EQ(bytes_of(status), 0u);
}

TEST_F(Series, JobsOnOtherBodiesInBetweenDropNothingWhileThereIsRoom) {
    start_worker();
    const Job one = make_job(100);
    const Job other = make_other_job(100);
    const Query query = query_of(Level::Count);
    const ClusterOptions options = everywhere(AnalysisMode::Never);
    EXPECT_GT(bytes_of(run_right(one, query, options)), 0u);
    EXPECT_GT(bytes_of(run_right(other, query, options)), 0u);
    EXPECT_EQ(bytes_of(run_right(one, query, options)), 0u);
    EXPECT_EQ(bytes_of(run_right(other, query, options)), 0u);
}

TEST_F(Series, WithoutRoomForAllBodiesThoseOfTheLastJobStay) {
    start_worker(1, {"--cache", "900KiB"});
    const Job one = make_job(100);
    const Job other = make_other_job(100);
    const Query query = query_of(Level::Count);
    const ClusterOptions options = everywhere(AnalysisMode::Never);
    const JobStatus first = run_right(one, query, options);
    ASSERT_EQ(first.traffic.blocks.evictions, 0u) << "the cache has no room for one job";
    const JobStatus second = run_right(other, query, options);
    EXPECT_EQ(second.traffic.blocks.evictions, 0u)
        << "a running job loses no block to an ended one";
    EXPECT_EQ(bytes_of(run_right(other, query, options)), 0u);
    EXPECT_GT(bytes_of(run_right(one, query, options)), 0u) << "the cache has room for both jobs";
}

TEST_F(Series, WithoutRoomForOneJobTheAnswersAreRight) {
    start_worker(1, {"--cache", "150KiB"});
    start_worker(1, {"--cache", "150KiB"});
    const Job job = make_job(60);
    for (const AnalysisMode analysis : {AnalysisMode::Always, AnalysisMode::Never}) {
        for (const Level level : {Level::Count, Level::Pairs}) {
            const JobStatus status = run_right(job, query_of(level), everywhere(analysis));
            EXPECT_GT(status.traffic.blocks.evictions, 0u);
        }
    }
}

} // namespace cd::tests
