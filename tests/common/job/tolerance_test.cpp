// Proves that an answer under a tolerance is always true: no contact is missed, separate scenarios
// are separate, the bound on the distance holds against exact distances, decided answers equal
// those without a tolerance, and no answer depends on how the cluster works.

#include "common/job/tolerance.hpp"

#include "tests/common/job/in_parts.hpp"
#include "tests/support/exact_distance.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace cd::tests {

namespace {

Query tolerant(Level level, double tolerance) {
    return query_of(level, 0, tolerance);
}

Scenario scenario_of(std::mt19937_64& random, double reach) {
    Scenario scenario;
    scenario.poses = {make_pose(random, 0.3), make_pose(random, reach)};
    if (random() % 3 == 0) {
        scenario.poses.b = make_matrix_pose(random, reach);
    }
    return scenario;
}

std::vector<ObbTree> small_trees(std::mt19937_64& random) {
    std::vector<ObbTree> trees;
    trees.push_back(make_tree(make_sphere(2)));
    trees.push_back(make_tree(make_gridded_box(Vec3(1.2, 0.8, 1), 3)));
    trees.push_back(make_tree(make_triangle_soup(random, 60, 0.3)));
    trees.push_back(make_tree(make_degenerate_soup(random, 40)));
    return trees;
}

/// Expects an answer under a tolerance to be consistent with the exact answer.
void expect_true(const ScenarioResult& answer, const ScenarioResult& exact) {
    if (answer.kind == ScenarioClass::Undecided) {
        EXPECT_TRUE(std::includes(
            exact.pairs.begin(), exact.pairs.end(), answer.pairs.begin(), answer.pairs.end()));
        EXPECT_LE(answer.pair_count, exact.pair_count);
        return;
    }
    EXPECT_EQ(encode_result(answer), encode_result(exact));
}

} // namespace

TEST(Tolerance, DecidedAnswersEqualThoseWithoutATolerance) {
    std::mt19937_64 random(3);
    const std::vector<ObbTree> trees = small_trees(random);
    int undecided = 0;
    int decided_contacts = 0;
    int separate = 0;
    for (int round = 0; round < 240; ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        const ObbTree& a = trees[random() % trees.size()];
        const ObbTree& b = trees[random() % trees.size()];
        const Scenario scenario = scenario_of(random, 2.5);
        const double tolerance = std::exp2(uniform(random, -2, 3));
        for (const Level level : levels) {
            const auto exact = run_scenario(a, b, scenario, query_of(level)).result;
            const auto answer = run_scenario(a, b, scenario, tolerant(level, tolerance)).result;
            expect_true(answer, exact);
            EXPECT_NE(exact.kind, ScenarioClass::Undecided);
            undecided += answer.kind == ScenarioClass::Undecided ? 1 : 0;
            separate += answer.kind == ScenarioClass::Separate ? 1 : 0;
            decided_contacts += answer.kind == ScenarioClass::Contact ? 1 : 0;
        }
    }
    EXPECT_GT(undecided, 100);
    EXPECT_GT(separate, 100);
    EXPECT_GT(decided_contacts, 5);
}

TEST(Tolerance, TheBoundIsNeverLessThanTheDistance) {
    std::mt19937_64 random(7);
    const std::vector<ObbTree> trees = small_trees(random);
    int apart = 0;
    for (int round = 0; round < 600; ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        const ObbTree& a = trees[random() % trees.size()];
        const ObbTree& b = trees[random() % trees.size()];
        const Scenario scenario = scenario_of(random, 1.7);
        const double tolerance = std::exp2(uniform(random, -2, 2));
        const Query query = tolerant(Level::Pairs, tolerance);
        const auto answer = run_scenario(a, b, scenario, query).result;
        if (answer.kind != ScenarioClass::Undecided) {
            EXPECT_EQ(answer.distance_bound, 0);
            continue;
        }
        if (run_scenario(a, b, scenario, query_of(Level::Count)).result.pair_count > 0) {
            EXPECT_GE(answer.distance_bound, 0);
            EXPECT_TRUE(answer.pair_count == 0 || answer.distance_bound == 0);
            continue;
        }
        ++apart;
        ASSERT_TRUE(std::isfinite(answer.distance_bound));
        // Overlapping boxes hold points no farther apart than the sum of the diameters, plus the
        // rounding margins of overlap test and bound.
        EXPECT_LE(answer.distance_bound, 1.001 * tolerance + 1e-5);
        EXPECT_TRUE(distance_is_at_most(a.mesh(), b.mesh(), scenario.poses, answer.distance_bound));
    }
    EXPECT_GT(apart, 20);
}

TEST(Tolerance, TheReferenceDistanceIsExact) {
    const Mesh box = make_box(Vec3(2, 2, 2));
    const auto is_within = [&](const Pose& pose, double bound) {
        return distance_is_at_most(box, box, {Pose{}, pose}, bound);
    };
    // Face to face, edge to edge, corner to corner.
    for (const auto& [pose, distance] : {std::pair(translation_pose(2.5, 0.1, 0.2), 0.5),
                                         std::pair(translation_pose(2.375, 2.5, 0.2), 0.625),
                                         std::pair(translation_pose(3, 4, 4), 3.0)}) {
        EXPECT_TRUE(is_within(pose, distance)) << distance;
        EXPECT_FALSE(is_within(pose, std::nextafter(distance, 0))) << distance;
    }
}

TEST(Tolerance, ACoarseAnswerCostsLittle) {
    const ObbTree torus = make_tree(make_torus(1, 0.4, 100, 40));
    const Scenario scenario = make_scenario({Pose{}, translation_pose(0.2, 0.1, 0.3)});
    const auto exact = run_scenario(torus, torus, scenario, query_of(Level::Pairs));
    const auto coarse = run_scenario(torus, torus, scenario, tolerant(Level::Pairs, 3));
    EXPECT_EQ(coarse.result.kind, ScenarioClass::Undecided);
    EXPECT_GT(coarse.result.distance_bound, 0);
    EXPECT_EQ(coarse.statistics.triangle_tests, 0u);
    EXPECT_LT(20 * coarse.statistics.box_tests, exact.statistics.box_tests);
}

TEST(Tolerance, AnyIsAContactAsSoonAsOneIsProven) {
    // Two boxes of different sizes: large triangles are decided, small ones stay undecided.
    const ObbTree a = make_tree(
        join({make_box(Vec3(2, 2, 2)), translated(make_box(Vec3(0.1, 0.1, 0.1)), {5, 0, 0})}));
    Scenario scenario;
    scenario.poses.b = translation_pose(0.3, 0.4, 0.2);
    const auto any = run_scenario(a, a, scenario, tolerant(Level::Any, 0.5)).result;
    EXPECT_EQ(any.kind, ScenarioClass::Contact);
    EXPECT_EQ(any.distance_bound, 0);
    scenario.poses.b = translation_pose(0.03, 0.04, 0.02);
    const auto count = run_scenario(a, a, scenario, tolerant(Level::Count, 0.5)).result;
    EXPECT_EQ(count.kind, ScenarioClass::Undecided);
    EXPECT_GT(count.pair_count, 0u);
    EXPECT_EQ(count.distance_bound, 0) << "a contact is proven";
}

TEST(Tolerance, PartsGiveTheRecordOfTheWholeInAnyOrder) {
    std::vector<ObbTree> trees;
    trees.push_back(make_tree(make_torus(1, 0.4, 80, 40)));
    trees.push_back(make_tree(make_sphere(4)));
    for (const ObbTree& tree : trees) {
        ASSERT_GT(tolerance_depth(tree), 0u);
    }
    int undecided = 0;
    for (SeededRandom random : seeds(3)) {
        for (int round = 0; round < 8; ++round) {
            SCOPED_TRACE(testing::Message() << "round " << round);
            const ObbTree& a = trees[random() % 2];
            const ObbTree& b = trees[random() % 2];
            const Scenario scenario = scenario_of(random, 1.5);
            const Query query = tolerant(levels[random() % 4], std::exp2(uniform(random, -4, 0)));
            const ScenarioResult parts = run_in_parts(a,
                                                      b,
                                                      {tolerance_depth(a), tolerance_depth(b)},
                                                      SubtreeForm::Binary,
                                                      scenario,
                                                      query,
                                                      random);
            const ScenarioResult whole = run_scenario(a, b, scenario, query).result;
            EXPECT_EQ(encode_result(parts), encode_result(whole));
            undecided += whole.kind == ScenarioClass::Undecided ? 1 : 0;
        }
    }
    EXPECT_GT(undecided, 5);
    EXPECT_LT(undecided, 24);
}

TEST(Tolerance, TheDepthIsAFunctionOfTheTree) {
    EXPECT_EQ(tolerance_depth(make_tree(make_sphere(3))), 0u);              // 512 triangles.
    EXPECT_EQ(tolerance_depth(make_tree(make_sphere(4))), 1u);              // 2,048 triangles.
    EXPECT_EQ(tolerance_depth(make_tree(make_torus(1, 0.4, 100, 40))), 3u); // 8,000 triangles.
}

TEST(Tolerance, IsAFiniteLength) {
    EXPECT_TRUE(check_tolerance(0));
    EXPECT_TRUE(check_tolerance(5e-324));
    EXPECT_FALSE(check_tolerance(-5e-324));
    EXPECT_FALSE(check_tolerance(std::numeric_limits<double>::infinity()));
    EXPECT_FALSE(check_tolerance(std::nan("")));
}

} // namespace cd::tests
