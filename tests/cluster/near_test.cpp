// Proves, with real processes over TCP, that a job with a clearance has the digest, the summary and
// the map of one process: at each level, with and without analysis, when a worker is killed, and
// after the master has started again.
#include "common/job/result/packed_map.hpp"
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/cluster/mortal_master.hpp"

#include <algorithm>
#include <csignal>

namespace cd::tests {

namespace {

constexpr double clearance = 0.1;

Query near_query(Level level) {
    Query query;
    query.level = level;
    query.clearance = clearance;
    return query;
}

Summary summary_in_one_process(const Job& job, const Query& query) {
    ResultMerger merger(job.scenarios.size());
    const ScenarioRunner runner(*job.a, *job.b, query);
    for (const Scenario& scenario : job.scenarios) {
        static_cast<void>(merger.add(runner.run(scenario).result));
    }
    return merger.summary();
}

} // namespace

TEST_F(Cluster, AClearanceHasTheAnswersOfOneProcessAtEveryLevel) {
    const Job job = make_job(300);
    start_worker(1);
    start_worker(2);
    for (const Level level : {Level::Any, Level::Count, Level::Pairs, Level::Contacts}) {
        const Query query = near_query(level);
        const Sha256 digest = job.digest_in_one_process(query);
        const Summary expected = summary_in_one_process(job, query);
        ASSERT_GT(expected.near, 3u);
        EXPECT_EQ(expected.near_pairs == 0, level == Level::Any);
        for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
            SCOPED_TRACE(testing::Message() << to_text(level) << ", " << to_text(mode));
            ClusterOptions options = many_blocks();
            options.analysis = mode;
            const JobStatus status = run(job, query, options);
            EXPECT_EQ(status.digest, digest);
            EXPECT_EQ(status.summary.near, expected.near);
            EXPECT_EQ(status.summary.near_pairs, expected.near_pairs);
            EXPECT_EQ(status.summary.pairs, expected.pairs);
            EXPECT_EQ(status.summary.separate, expected.separate);
        }
    }
}

TEST_F(Cluster, AClearanceOfZeroFindsTheContactsAlone) {
    const Job job = make_job(200);
    start_worker(2);
    Query query = near_query(Level::Pairs);
    query.clearance = 0;
    const JobStatus zero = run(job, query);
    EXPECT_EQ(zero.digest, job.digest_in_one_process(query));
    query.clearance.reset();
    const JobStatus without = run(job, query);
    EXPECT_EQ(zero.summary.near, 0u);
    EXPECT_EQ(zero.summary.pairs, without.summary.pairs);
    EXPECT_EQ(zero.summary.separate, without.summary.separate);
    EXPECT_NE(zero.digest, without.digest) << "the records say that the query had a clearance";
}

TEST_F(Cluster, ALimitAndIgnoredTrianglesHoldForNearPairs) {
    const Job job = make_job(150);
    start_worker(1);
    start_worker(1);
    Query query = near_query(Level::Contacts);
    query.limit_pairs = 7;
    query.ignored = {{0, 2000, 0, 700}};
    const JobStatus status = run(job, query);
    EXPECT_EQ(status.digest, job.digest_in_one_process(query));
    EXPECT_GT(status.summary.cut, 10u);
    EXPECT_EQ(status.summary.near_pairs, summary_in_one_process(job, query).near_pairs);
}

TEST_F(Cluster, TheMapOfAClearanceIsThatOfOneProcessThoughAWorkerIsKilled) {
    const Job job = make_job(1000);
    Query query = near_query(Level::Count);
    query.maps = true;
    const ContactMap expected = job.map_in_one_process(query);
    ASSERT_TRUE(std::ranges::any_of(expected.parts.pairs,
                                    [](const PartPairContacts& pair) { return pair.near > 0; }));
    start_worker(1);
    Process& victim = start_worker(2);
    bool is_killed = false;
    const JobId id = submit(job, query, {});
    const JobStatus status = finish(id, [&](const JobStatus& now) {
        if (!is_killed && now.summary.merged() > now.answered_by_master + 50) {
            victim.signal(SIGKILL);
            is_killed = true;
        }
    });
    EXPECT_TRUE(is_killed);
    EXPECT_EQ(status.digest, job.digest_in_one_process(query));
    const auto answer = connection_->contact_map({id});
    ASSERT_TRUE(answer) << answer.error().detail;
    const auto map = unpack_map(answer.value().map, any_map(1000));
    ASSERT_TRUE(map) << map.error().detail;
    EXPECT_EQ(map.value(), expected);
}

namespace {
class NearRestart : public MortalCluster {};
} // namespace

TEST_F(NearRestart, AClearanceAndItsResultsOutliveTheMaster) {
    const Job job = make_job(3000);
    const Query query = near_query(Level::Count);
    start_worker();
    start_worker();
    auto connection = connect();
    const JobId id = submit(*connection, job, query);
    int killed = 0;
    for (const std::uint64_t point : {1u, 1000u, 2000u}) {
        if (watch_until(*connection, id, point).state != JobState::Running) {
            break;
        }
        restart_master(connection);
        ++killed;
    }
    EXPECT_GE(killed, 1);
    const JobStatus status = finish(*connection, id);
    EXPECT_EQ(status.state, JobState::Done) << status.failure;
    EXPECT_EQ(status.digest, job.digest_in_one_process(query));
    const Summary expected = summary_in_one_process(job, query);
    EXPECT_EQ(status.summary.near, expected.near);
    EXPECT_EQ(status.summary.near_pairs, expected.near_pairs);
    EXPECT_EQ(fetched(*connection, status), 3000u);
}

} // namespace cd::tests
