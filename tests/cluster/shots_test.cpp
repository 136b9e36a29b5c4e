// Proves, with real processes over TCP, that shot lines have the digest, the summary and the map of
// one process: whether the master analyses or not, at both levels, and of first hits.
#include "client/bundle/bundle_poses.hpp"
#include "common/job/result/packed_map.hpp"
#include "tests/cluster/cluster_fixture.hpp"

#include <array>

namespace cd::tests {

namespace {

Query shots_query(Level level) {
    Query query;
    query.level = level;
    query.question = Question::Shots;
    return query;
}

/// Makes a job of lines through a torus in parts, from some directions.
Job make_shots() {
    ThreadPool pool(2);
    LineGrid grid;
    grid.spacing = 0.0625;
    grid.tile = 16;
    const auto torus = share(in_parts(make_torus(1, 0.4, 100, 40), 7));
    const Aabb box = bounding_box(torus->vertices());
    const auto lines = share(make_bundle(grid, bundle_reach(box)).value());
    const std::array<ShotView, 4> views{{{0, 0}, {30, 20}, {0, 90}, {200, -45}}};
    Job job;
    job.a = std::make_shared<const ObbTree>(build_tree(torus, {}, pool));
    job.b = std::make_shared<const ObbTree>(build_tree(lines, {}, pool));
    const std::vector<BundlePose> poses = bundle_poses(grid, views, box).value();
    for (const BundlePose& pose : poses) {
        Scenario scenario;
        scenario.index = job.scenarios.size();
        scenario.poses.b = pose.pose;
        job.scenarios.push_back(scenario);
    }
    return job;
}

Summary in_one_process(const Job& job, const Query& query) {
    ResultMerger merger(job.scenarios.size());
    const ScenarioRunner runner(*job.a, *job.b, query);
    for (const Scenario& scenario : job.scenarios) {
        static_cast<void>(merger.add(runner.run(scenario).result));
    }
    return merger.summary();
}

void expect_answers(const JobStatus& status, const Job& job, const Query& query) {
    const Summary expected = in_one_process(job, query);
    EXPECT_EQ(status.state, JobState::Done) << status.failure;
    EXPECT_EQ(status.digest, job.digest_in_one_process(query));
    EXPECT_EQ(status.summary.contact, expected.contact);
    EXPECT_EQ(status.summary.separate, expected.separate);
    EXPECT_EQ(status.summary.pairs, expected.pairs);
    EXPECT_EQ(status.summary.failed, 0u);
}

} // namespace

TEST_F(Cluster, LinesHaveTheHitsOfOneProcessWhoeverAnalyses) {
    const Job job = make_shots();
    start_worker(1);
    start_worker(2);
    ASSERT_GT(in_one_process(job, shots_query(Level::Count)).pairs, 1000u);
    for (const Level level : {Level::Count, Level::Pairs}) {
        for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
            for (const bool first_hits : {false, true}) {
                SCOPED_TRACE(testing::Message()
                             << to_text(level) << ", " << to_text(mode) << ", " << first_hits);
                ClusterOptions options = many_blocks();
                options.analysis = mode;
                Query query = shots_query(level);
                query.first_hits = first_hits;
                expect_answers(run(job, query, options), job, query);
            }
        }
    }
}

TEST_F(Cluster, ASecondJobOfTheSameLinesGetsNoGeometry) {
    const Job job = make_shots();
    start_worker(2);
    ClusterOptions options = many_blocks();
    options.analysis = AnalysisMode::Never;
    EXPECT_GT(run(job, shots_query(Level::Pairs), options).traffic.blocks.master_bytes, 0u);
    const JobStatus again = run(job, shots_query(Level::Count), options);
    expect_answers(again, job, shots_query(Level::Count));
    EXPECT_EQ(again.traffic.blocks.master_bytes, 0u);
}

TEST_F(Cluster, AMapOfCrossingsIsThatOfOneProcess) {
    const Job job = make_shots();
    start_worker(1);
    start_worker(1);
    Query query = shots_query(Level::Count);
    query.maps = true;
    const JobId id = submit(job, query, many_blocks());
    expect_answers(finish(id, [](const JobStatus&) {}), job, query);
    const auto answer = connection_->contact_map({id});
    ASSERT_TRUE(answer) << answer.error().detail;
    const auto map = unpack_map(answer.value().map, any_map(job.scenarios.size()));
    ASSERT_TRUE(map) << map.error().detail;
    EXPECT_EQ(map.value(), job.map_in_one_process(query));
}

} // namespace cd::tests
