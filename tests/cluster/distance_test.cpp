// Proves, with real processes over TCP, that a job that asks how far apart the bodies are has the
// digest and the summary of one process: whether the master analyses or not, with and without
// up_to, when a worker is killed, and after the master has started again; and that a worker fetches
// the blocks of the nearest roots first.
#include "common/job/query_roots.hpp"
#include "common/tree/cut.hpp"
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/cluster/mortal_master.hpp"

#include <csignal>
#include <set>

namespace cd::tests {

namespace {

Query distance_query(std::optional<double> up_to = std::nullopt) {
    Query query;
    query.level = Level::Any;
    query.question = Question::Distance;
    query.up_to = up_to;
    return query;
}

/// The answers of one process.
struct Distances {
    Summary summary;
    std::uint64_t known = 0; ///< Scenarios with a distance.
};

Distances in_one_process(const Job& job, const Query& query) {
    Distances distances;
    ResultMerger merger(job.scenarios.size());
    const ScenarioRunner runner(*job.a, *job.b, query);
    for (const Scenario& scenario : job.scenarios) {
        const ScenarioResult result = runner.run(scenario).result;
        distances.known += result.nearest ? 1 : 0;
        static_cast<void>(merger.add(result));
    }
    distances.summary = merger.summary();
    return distances;
}

void expect_answers(const JobStatus& status, const Job& job, const Query& query) {
    const Summary expected = in_one_process(job, query).summary;
    EXPECT_EQ(status.state, JobState::Done) << status.failure;
    EXPECT_EQ(status.digest, job.digest_in_one_process(query));
    EXPECT_EQ(status.summary.contact, expected.contact);
    EXPECT_EQ(status.summary.inside, expected.inside);
    EXPECT_EQ(status.summary.separate, expected.separate);
    EXPECT_EQ(status.summary.failed, 0u);
    EXPECT_EQ(status.summary.pairs + status.summary.near_pairs, 0u);
}

} // namespace

TEST_F(Cluster, ADistanceHasTheAnswersOfOneProcessWhoeverAnalyses) {
    const Job job = make_job(300);
    start_worker(1);
    start_worker(2);
    const Distances all = in_one_process(job, distance_query());
    ASSERT_GT(all.known, 20u);
    ASSERT_GT(all.summary.contact, 20u);
    const Distances within = in_one_process(job, distance_query(0.25));
    ASSERT_GT(within.known, 3u);
    ASSERT_LT(within.known, all.known);
    for (const std::optional<double> up_to : {std::optional<double>(), std::optional(0.25)}) {
        for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
            SCOPED_TRACE(testing::Message() << up_to.value_or(-1) << ", " << to_text(mode));
            ClusterOptions options = many_blocks();
            options.analysis = mode;
            const Query query = distance_query(up_to);
            expect_answers(run(job, query, options), job, query);
        }
    }
}

TEST_F(Cluster, ASweepFetchesFewerBlocksThanItsBoundsName) {
    Job job = make_job(60);
    for (std::uint64_t i = 0; i < job.scenarios.size(); ++i) {
        const double y = -0.3 + 0.01 * static_cast<double>(i);
        job.scenarios[i].poses = {Pose{}, translation_pose(2.6, y, 0.1)};
    }
    const Query query = distance_query();
    ClusterOptions options;
    options.depths = {9, 6};
    const TreeTop top_a = cut_tree(*job.a, 9);
    const TreeTop top_b = cut_tree(*job.b, 6);
    std::set<RootIndex> named_a;
    std::set<RootIndex> named_b;
    for (const Scenario& scenario : job.scenarios) {
        const auto roots = query_roots(top_a, top_b, scenario, query);
        ASSERT_TRUE(roots) << roots.error().detail;
        for (const RootPair& pair : roots.value().pairs) {
            named_a.insert(pair.a);
            named_b.insert(pair.b);
        }
    }
    for (const AnalysisMode mode : {AnalysisMode::Never, AnalysisMode::Always}) {
        SCOPED_TRACE(testing::Message() << to_text(mode));
        Process& worker = start_worker(1); // A worker keeps the blocks of an earlier job.
        options.analysis = mode;
        const JobStatus status = run(job, query, options);
        expect_answers(status, job, query);
        const BlockTraffic& blocks = status.traffic.blocks;
        EXPECT_GT(blocks.misses + blocks.hinted, 0u);
        EXPECT_LT(2 * (blocks.misses + blocks.hinted), named_a.size() + named_b.size());
        worker.signal(SIGTERM);
        EXPECT_EQ(worker.wait(), 0);
    }
}

TEST_F(Cluster, ADistancePassesOverIgnoredTriangles) {
    const Job job = make_job(60);
    start_worker(1);
    start_worker(1);
    Query query = distance_query();
    query.ignored = {{0, 2000, 0, 700}};
    const Sha256 of_all = job.digest_in_one_process(distance_query());
    ASSERT_NE(job.digest_in_one_process(query), of_all);
    expect_answers(run(job, query), job, query);
    query.up_to = 0.5;
    expect_answers(run(job, query), job, query);
}

TEST_F(Cluster, ADistanceIsThatOfOneProcessThoughAWorkerIsKilled) {
    const Job job = make_job(1000);
    const Query query = distance_query();
    start_worker(1);
    Process& victim = start_worker(2);
    bool is_killed = false;
    const JobStatus status = finish(submit(job, query, {}), [&](const JobStatus& now) {
        if (!is_killed && now.summary.merged() > now.answered_by_master + 50) {
            victim.signal(SIGKILL);
            is_killed = true;
        }
    });
    EXPECT_TRUE(is_killed);
    expect_answers(status, job, query);
}

namespace {
class DistanceRestart : public MortalCluster {};
} // namespace

TEST_F(DistanceRestart, TheQuestionAndItsResultsOutliveTheMaster) {
    const Job job = make_job(1500);
    const Query query = distance_query(1);
    start_worker();
    start_worker();
    auto connection = connect();
    const JobId id = submit(*connection, job, query);
    int killed = 0;
    for (const std::uint64_t point : {1u, 500u, 1000u}) {
        if (watch_until(*connection, id, point).state != JobState::Running) {
            break;
        }
        restart_master(connection);
        ++killed;
    }
    EXPECT_GE(killed, 1);
    const JobStatus status = finish(*connection, id);
    expect_answers(status, job, query);
    EXPECT_EQ(fetched(*connection, status), 1500u);
}

} // namespace cd::tests
