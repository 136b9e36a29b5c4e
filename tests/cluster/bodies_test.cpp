// Proves, with real processes over TCP, that a job of more than two bodies has the digest of one
// process: whether the master analyses or not, at each level and question, with ignored triangles,
// when a worker is killed, and after the master has started again.
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/many_bodies.hpp"

#include <csignal>

namespace cd::tests {

namespace {

/// Returns the digest of a job that runs in this process.
Sha256 digest_here(const ManyBodies& job, const Query& query) {
    ResultMerger merger(job.scenarios.size());
    const ScenarioRunner runner(TreesByBody(job.trees), query);
    ScenarioSession session(runner);
    for (const Scenario& scenario : job.scenarios) {
        EXPECT_EQ(merger.add(session.run(scenario).result), ResultMerger::Outcome::Added);
    }
    return merger.digest().value();
}

JobId submit_bodies(Connection& connection,
                    const ManyBodies& job,
                    const Query& query,
                    AnalysisMode analysis = AnalysisMode::Auto) {
    std::vector<NamedMesh> meshes;
    Submit message;
    message.name = "bodies";
    message.query = query;
    message.cluster.analysis = analysis;
    for (std::size_t body = 0; body < job.trees.size(); ++body) {
        const std::string name = "body" + std::to_string(body);
        meshes.push_back({name, job.trees[body]->mesh_pointer()});
        message.bodies.push_back({job.trees[body]->mesh().hash(), name});
        message.cluster.set_depth(body, 5);
    }
    const Status uploaded = connection.upload(meshes, [](auto&&...) {});
    EXPECT_TRUE(uploaded) << uploaded.error().detail;
    const auto poses = make_list_source(job.scenarios);
    const auto accepted = connection.submit(message, *poses);
    EXPECT_TRUE(accepted) << accepted.error().detail;
    return accepted ? accepted.value() : JobId{};
}

void expect_digest(const JobStatus& status, const ManyBodies& job, const Query& query) {
    EXPECT_EQ(status.state, JobState::Done) << status.failure;
    EXPECT_EQ(status.summary.failed, 0u);
    EXPECT_EQ(status.digest, digest_here(job, query));
}

std::vector<Query> some_queries() {
    std::vector<Query> queries;
    for (const Level level : levels) {
        queries.push_back(query_of(level));
    }
    queries.push_back(query_of(Level::Pairs));
    queries.back().ignored = {
        {0, 1600, 0, 300, 0, 1}, {0, 500, 0, 192, 0, 4}, {9, 99, 0, 512, 1, 3}};
    queries.push_back(query_of(Level::Count));
    queries.back().clearance = 0.1;
    queries.push_back(query_of(Level::Any));
    queries.back().question = Question::Distance;
    return queries;
}

} // namespace

TEST_F(Cluster, AJobOfFiveBodiesHasTheDigestOfOneProcess) {
    const ManyBodies job = make_many_bodies(30);
    start_worker(1);
    start_worker(2);
    for (const Query& query : some_queries()) {
        for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
            SCOPED_TRACE(testing::Message() << to_text(query.level) << ", " << to_text(mode));
            const JobId id = submit_bodies(*connection_, job, query, mode);
            expect_digest(finish_job(*connection_, id), job, query);
        }
    }
}

TEST_F(Cluster, ASecondJobOnTheBodiesOfAFirstGetsNoGeometry) {
    ManyBodies job = make_many_bodies(60);
    start_worker(2);
    for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
        (void)finish_job(*connection_, submit_bodies(*connection_, job, Query{}, mode));
    }
    job.scenarios.resize(job.scenarios.size() / 2);
    for (const Query& query : {query_of(Level::Any), query_of(Level::Count)}) {
        const JobStatus status = finish_job(*connection_, submit_bodies(*connection_, job, query));
        expect_digest(status, job, query);
        EXPECT_EQ(status.traffic.blocks.master_bytes, 0u);
    }
}

TEST_F(Cluster, AJobOfFiveBodiesHasItsDigestThoughAWorkerIsKilled) {
    const ManyBodies job = make_many_bodies(200);
    const Query query = query_of(Level::Pairs);
    start_worker(1);
    Process& victim = start_worker(2);
    bool is_killed = false;
    const JobId id = submit_bodies(*connection_, job, query);
    const JobStatus status = finish(id, [&](const JobStatus& now) {
        if (!is_killed && now.summary.merged() > now.answered_by_master + 50) {
            victim.signal(SIGKILL);
            is_killed = true;
        }
    });
    EXPECT_TRUE(is_killed);
    expect_digest(status, job, query);
}

namespace {
class BodiesRestart : public MortalCluster {};
} // namespace

TEST_F(BodiesRestart, TheBodiesOfAJobOutliveTheMaster) {
    const ManyBodies job = make_many_bodies(300);
    const Query query = query_of(Level::Pairs);
    start_worker();
    start_worker();
    auto connection = connect();
    const JobId id = submit_bodies(*connection, job, query);
    int killed = 0;
    for (const std::uint64_t point : {1u, 1000u, 2000u}) {
        if (watch_until(*connection, id, point).state != JobState::Running) {
            break;
        }
        restart_master(connection);
        ++killed;
    }
    EXPECT_GE(killed, 1);
    expect_digest(finish(*connection, id), job, query);
}

} // namespace cd::tests
