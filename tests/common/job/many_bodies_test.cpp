// Proves that the scenarios of many bodies have the results of their two bodies alone: of the right
// trees, with the triangles that these two ignore, and inside each other or not.

#include "tests/support/many_bodies.hpp"

#include "common/job/run_scenario.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

/// Runs a scenario as that of a job with these two bodies alone.
ScenarioResult run_alone(const ManyBodies& job, const Scenario& scenario, Query query) {
    std::erase_if(query.ignored, [&](const IgnoredRange& range) {
        return range.body_a != scenario.body_a || range.body_b != scenario.body_b;
    });
    for (IgnoredRange& range : query.ignored) {
        range.body_a = 0;
        range.body_b = 1;
    }
    Scenario alone = scenario;
    alone.body_a = 0;
    alone.body_b = 1;
    ScenarioResult result =
        run_scenario(*job.trees[scenario.body_a], *job.trees[scenario.body_b], alone, query).result;
    result.body_a = scenario.body_a;
    result.body_b = scenario.body_b;
    return result;
}

/// Expects the results of each two bodies alone, and returns how often each class occurs.
std::map<ScenarioClass, int> expect_results_alone(const ManyBodies& job, const Query& query) {
    std::map<ScenarioClass, int> classes;
    const ScenarioRunner runner(TreesByBody(job.trees), query);
    ScenarioSession session(runner);
    for (const Scenario& scenario : job.scenarios) {
        const Bytes expected = encode_result(run_alone(job, scenario, query));
        const ScenarioResult result = session.run(scenario).result;
        EXPECT_EQ(encode_result(result), expected) << "scenario " << scenario.index;
        EXPECT_EQ(encode_result(runner.run(scenario).result), expected);
        ++classes[result.kind];
    }
    return classes;
}

Query query_of_distance() {
    Query query = query_of(Level::Any);
    query.question = Question::Distance;
    return query;
}

} // namespace

TEST(ManyBodies, ScenariosHaveTheResultsOfTheirTwoBodiesAlone) {
    const ManyBodies job = make_many_bodies(12);
    for (const Level level : levels) {
        SCOPED_TRACE(to_text(level));
        auto classes = expect_results_alone(job, query_of(level));
        EXPECT_GT(classes[ScenarioClass::Separate], 5);
        EXPECT_GT(classes[ScenarioClass::Inside], 0);
    }
    Query near = query_of(Level::Pairs);
    near.clearance = 0.2;
    EXPECT_GT(expect_results_alone(job, near)[ScenarioClass::Near], 0);
    EXPECT_GT(expect_results_alone(job, query_of_distance())[ScenarioClass::Separate], 0);
}

TEST(ManyBodies, TrianglesAreIgnoredBetweenTheTwoBodiesThatARangeNames) {
    const ManyBodies job = make_many_bodies(12);
    const auto all = [&](std::uint32_t body) {
        return static_cast<std::uint32_t>(job.trees[body]->mesh().triangles().size());
    };
    Query query = query_of(Level::Pairs);
    query.ignored = {{0, all(0), 0, all(1), 0, 1},
                     {0, 100, 0, 200, 0, 3},
                     {50, 300, 0, 12, 1, 3},
                     {0, all(2), 0, all(4), 2, 4}};
    ASSERT_TRUE(are_in_order(query.ignored));
    expect_results_alone(job, query);
    expect_results_alone(job, [&] {
        Query distance = query_of_distance();
        distance.ignored = query.ignored;
        return distance;
    }());
    int ignored = 0;
    int differ = 0;
    const Query nothing = query_of(Level::Pairs);
    for (const Scenario& scenario : job.scenarios) {
        const auto with = run_alone(job, scenario, query);
        const bool is_same =
            encode_result(with) == encode_result(run_alone(job, scenario, nothing));
        const auto bodies = std::pair(scenario.body_a, scenario.body_b);
        if (bodies == std::pair(0u, 1u)) {
            EXPECT_EQ(with.pair_count, 0u);
            ++ignored;
        }
        differ += is_same ? 0 : 1;
    }
    EXPECT_GT(ignored, 0);
    EXPECT_GT(differ, 0);
}

TEST(ManyBodies, OneSearchServesBodiesWithOneMesh) {
    const ManyBodies job = make_many_bodies(1);
    std::set<std::pair<const ObbTree*, const ObbTree*>> pairs;
    KeptSearches<const ObbTree*> kept;
    for (const Scenario& scenario : job.scenarios) {
        const ObbTree* const a = job.trees[scenario.body_a].get();
        const ObbTree* const b = job.trees[scenario.body_b].get();
        KeptSearch& search = kept.of(a, b);
        EXPECT_EQ(search.search == nullptr, pairs.emplace(a, b).second);
        if (search.search == nullptr) {
            search.search = make_search(a->view(), b->view(), scenario.poses);
        }
    }
    EXPECT_EQ(job.scenarios.size(), 10u);
    EXPECT_EQ(pairs.size(), 6u);
}

} // namespace cd::tests
