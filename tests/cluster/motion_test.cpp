// Proves, with real processes over TCP, that motions have the digest of one process: whether the
// master analyses or not, at both levels, with and without a clearance, whenever the search ends;
// and that the status tells the sums of their cells, after a restart of the master too.
#include "common/motion/motion_keys.hpp"
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/motions.hpp"

#include <array>
#include <optional>
#include <random>
#include <vector>

namespace cd::tests {

namespace {

constexpr double resolution = 0.01;

Query motion_query(Level level, Until until, std::optional<double> clearance) {
    Query query;
    query.level = level;
    query.question = Question::Motion;
    query.motion = MotionQuery{resolution, until};
    query.clearance = clearance;
    return query;
}

/// Makes a job in which a box flies around and through a torus.
Job make_motions(int count = 60) {
    ThreadPool pool(2);
    Job job;
    job.a = std::make_shared<const ObbTree>(
        build_tree(share(in_parts(make_torus(1, 0.4, 60, 24), 7)), {}, pool));
    job.b = std::make_shared<const ObbTree>(
        build_tree(share(make_gridded_box(Vec3(0.3, 0.2, 0.2), 4)), {}, pool));
    std::mt19937_64 random(11);
    std::vector<PosePair> poses;
    for (int i = 0; i <= count; ++i) {
        const Vec3 place = random_point(random, 2);
        poses.push_back({turned_pose(2.0 * i, Vec3(0, 0, 1)),
                         turned_pose(uniform(random, 0, 60), random_axis(random), place)});
    }
    const BodyRadii radii{body_radius(job.a->mesh().vertices()),
                          body_radius(job.b->mesh().vertices())};
    const std::vector<PosePair> keys = round_keys(poses, radii, resolution).value().keys;
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        Scenario scenario;
        scenario.index = i;
        scenario.poses = keys[i];
        scenario.to = keys[i + 1];
        job.scenarios.push_back(scenario);
    }
    return job;
}

} // namespace

TEST_F(Cluster, MotionsHaveTheAnswersOfOneProcessWhoeverAnalyses) {
    const Job job = make_motions();
    start_worker(1);
    start_worker(2);
    for (const Level level : {Level::Any, Level::Pairs}) {
        for (const Until until : {Until::Contact, Until::Free, Until::End}) {
            for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
                SCOPED_TRACE(testing::Message() << to_text(level) << ", " << to_text(mode));
                ClusterOptions options = many_blocks();
                options.analysis = mode;
                const auto clearance =
                    until == Until::End ? std::optional(0.02) : std::optional<double>();
                const Query query = motion_query(level, until, clearance);
                const JobStatus status = run(job, query, options);
                EXPECT_EQ(status.state, JobState::Done) << status.failure;
                EXPECT_EQ(status.digest, job.digest_in_one_process(query));
                EXPECT_EQ(status.summary.failed, 0u);
                const Summary& summary = status.summary;
                EXPECT_GT(summary.separate + summary.inside, 2u);
                // Few of them begin in contact, from which a search for the way out tells more.
                EXPECT_GT(summary.contact + summary.touch + summary.cross + summary.near,
                          until == Until::Free ? 2u : 10u);
            }
        }
    }
}

namespace {

class MotionRestart : public MortalCluster {};

/// Returns the sum over the motions of a job in one process.
SearchEffort effort_in_one_process(const Job& job, const Query& query) {
    const ScenarioRunner runner(*job.a, *job.b, query);
    SearchEffort sum;
    for (const Scenario& scenario : job.scenarios) {
        sum += runner.run(scenario).statistics.effort;
    }
    return sum;
}

} // namespace

TEST_F(MotionRestart, TheCellsOfEachMotionCountOnceHoweverOftenTheMasterIsKilled) {
    const Job job = make_motions(300);
    const Query query = motion_query(Level::Any, Until::Contact, std::nullopt);
    start_worker(); // The only one, so that no copies of scenarios run.
    auto connection = connect();
    const JobId id = submit(*connection, job, query);
    SearchEffort before;
    int killed = 0;
    for (const std::uint64_t point : {1u, 100u, 200u}) {
        const JobStatus status = watch_until(*connection, id, point);
        if (status.state != JobState::Running) {
            break;
        }
        EXPECT_GT(status.statistics.search.effort.cells, before.cells) << "a running job tells";
        before = status.statistics.search.effort;
        restart_master(connection);
        ++killed;
    }
    EXPECT_GE(killed, 1);
    const JobStatus status = finish(*connection, id);
    EXPECT_EQ(status.state, JobState::Done) << status.failure;
    const SearchEffort expected = effort_in_one_process(job, query);
    EXPECT_GT(expected.cells, 5 * job.scenarios.size());
    EXPECT_EQ(status.statistics.search.effort, expected);
}

} // namespace cd::tests
