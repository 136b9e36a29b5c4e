// Proves that a scenario under a clearance has one result for whole trees and for subtrees of any
// cut, and that each level contains what it promises about near pairs.

#include "common/distance/triangle_distance.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/common/job/in_parts.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

namespace cd::tests {

namespace {

Query near_query(Level level, double clearance, std::uint64_t limit_pairs = 0) {
    Query query = query_of(level, limit_pairs);
    query.clearance = clearance;
    return query;
}

ScenarioResult near_result(const ObbTree& tree, const Pose& pose, const Query& query) {
    return run_scenario(tree, tree, make_scenario({Pose{}, pose}), query).result;
}

std::uint64_t near_in(const ScenarioResult& result) {
    return static_cast<std::uint64_t>(
        std::ranges::count(result.pairs, PairClass::Near, &ContactPair::kind));
}

} // namespace

TEST(NearScenario, PartsGiveTheSameRecordAsTheWhole) {
    std::mt19937_64 random(7);
    std::vector<ObbTree> trees;
    trees.push_back(make_tree(make_sphere(2)));
    trees.push_back(make_tree(make_gridded_box(Vec3(1.5, 1, 1), 4)));
    trees.push_back(make_tree(make_triangle_soup(random, 60)));
    trees.push_back(make_tree(make_degenerate_soup(random, 40)));
    std::map<ScenarioClass, int> classes;
    for (int round = 0; round < 40; ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        const ObbTree& a = trees[random() % trees.size()];
        const ObbTree& b = trees[random() % trees.size()];
        const Scenario scenario =
            make_scenario({make_pose(random, 0.2), make_pose(random, 2.5)}, 17);
        const bool is_wide = suits_wide_tree(a.view()) && suits_wide_tree(b.view());
        for (const Level level : levels) {
            const Query query = near_query(level, 0.2, round % 3 == 0 ? 5 : 0);
            const std::array<std::uint32_t, 2> depths{static_cast<std::uint32_t>(random() % 12),
                                                      static_cast<std::uint32_t>(random() % 12)};
            const SubtreeForm form =
                is_wide && random() % 4 > 0 ? SubtreeForm::Wide : SubtreeForm::Binary;
            const ScenarioResult whole = run_scenario(a, b, scenario, query).result;
            const Bytes record = encode_result(whole);
            const ScenarioResult parts = run_in_parts(a, b, depths, form, scenario, query, random);
            ASSERT_EQ(encode_result(parts), record);
            const auto decoded = decode_result(record);
            ASSERT_TRUE(decoded) << decoded.error().detail;
            EXPECT_EQ(encode_result(decoded.value()), record);
            ++classes[whole.kind];
        }
    }
    EXPECT_GT(classes[ScenarioClass::Near], 5);
    EXPECT_GT(classes[ScenarioClass::Separate], 5);
    EXPECT_GT(classes[ScenarioClass::Contact], 5);
}

TEST(NearScenario, EachLevelContainsWhatItPromises) {
    const ObbTree sphere = make_tree(make_sphere(2));
    const Pose apart = translation_pose(2.05, 0, 0);
    for (const Level level : levels) {
        const ScenarioResult result = near_result(sphere, apart, near_query(level, 0.1));
        EXPECT_EQ(result.kind, ScenarioClass::Near) << to_text(level);
        EXPECT_TRUE(result.has_clearance);
        EXPECT_EQ(result.pair_count, 0u);
        EXPECT_EQ(result.near_count > 0, level != Level::Any);
        EXPECT_EQ(near_in(result), level >= Level::Pairs ? result.near_count : 0u);
        EXPECT_EQ(near_result(sphere, apart, near_query(level, 0.04)).kind,
                  ScenarioClass::Separate);
    }
    // Without contacts of their own, triangles around a contact are near.
    const Pose crossing = translation_pose(1.9, 0, 0);
    const ScenarioResult counted = near_result(sphere, crossing, near_query(Level::Count, 0.1));
    EXPECT_EQ(counted.kind, ScenarioClass::Cross);
    EXPECT_GT(counted.near_count, 0u);
    EXPECT_EQ(counted.pair_count, near_result(sphere, crossing, query_of(Level::Count)).pair_count);
    EXPECT_EQ(near_result(sphere, crossing, near_query(Level::Any, 0.1)).kind,
              ScenarioClass::Contact);
}

TEST(NearScenario, ANearPairHasItsTwoNearestPointsAndItsDistance) {
    const ObbTree sphere = make_tree(make_sphere(2));
    const Pose pose = Pose::from_quaternion({2, 1, 0, 3}, Vec3(1.9, 0.1, 0.2));
    const ScenarioResult result = near_result(sphere, pose, near_query(Level::Contacts, 0.1));
    TriangleDistance distance({Pose{}, pose}, DistanceStage::Exact);
    ASSERT_EQ(result.near_distances.size(), near_in(result));
    ASSERT_GT(near_in(result), 10u);
    ASSERT_GT(result.pair_count, 0u);
    std::size_t near = 0;
    for (std::size_t i = 0; i < result.pairs.size(); ++i) {
        if (result.pairs[i].kind != PairClass::Near) {
            continue;
        }
        const Corners a = sphere.mesh().corners(result.pairs[i].a);
        const Corners b = sphere.mesh().corners(result.pairs[i].b);
        const NearestPoints nearest = distance.nearest(a, b);
        ASSERT_EQ(result.point_offsets[i + 1] - result.point_offsets[i], 2u);
        EXPECT_EQ(result.point_origins[i], nearest.origin);
        EXPECT_EQ(result.points[result.point_offsets[i]], nearest.of_a);
        EXPECT_EQ(result.points[result.point_offsets[i] + 1], nearest.of_b);
        EXPECT_EQ(result.near_distances[near++], distance.rounded(a, b));
        EXPECT_NEAR((nearest.of_b - nearest.of_a).norm(), distance.rounded(a, b), 1e-15);
    }
}

TEST(NearScenario, ABodyInsideAnotherIsInsideAndItsNearPairsAreListed) {
    const ObbTree large = make_tree(make_gridded_box(Vec3(2, 2, 2), 4));
    const ObbTree small = make_tree(make_box(Vec3(1.9, 1, 1)));
    for (const Level level : levels) {
        const ScenarioResult result =
            run_scenario(large, small, make_scenario(PosePair{}), near_query(level, 0.06)).result;
        EXPECT_EQ(result.kind, ScenarioClass::Inside) << to_text(level);
        EXPECT_EQ(result.near_count > 0, level != Level::Any);
    }
}

TEST(NearScenario, ATouchWithNearPairsIsJudgedByItsContactsAlone) {
    const ObbTree box = make_tree(make_gridded_box(Vec3(1, 1, 1), 2));
    for (const Level level : {Level::Count, Level::Pairs, Level::Contacts}) {
        for (const std::uint64_t limit : {std::uint64_t{0}, std::uint64_t{3}}) {
            const ScenarioResult touching =
                near_result(box, translation_pose(1, 0, 0), near_query(level, 0.3, limit));
            EXPECT_EQ(touching.kind, ScenarioClass::Touch);
            EXPECT_GT(touching.near_count, 0u);
            // The boxes overlap face by face, so that no pair is proper.
            const ScenarioResult shifted =
                near_result(box, translation_pose(0.5, 0, 0), near_query(level, 0.3, limit));
            EXPECT_EQ(shifted.kind,
                      near_result(box, translation_pose(0.5, 0, 0), query_of(level)).kind);
        }
    }
}

TEST(NearScenario, AMapHasAllPairs) {
    const ObbTree sphere = make_tree(make_sphere(2));
    Query query = near_query(Level::Count, 0.1);
    query.maps = true;
    const ScenarioRun run =
        run_scenario(sphere, sphere, make_scenario({Pose{}, translation_pose(1.9, 0, 0)}), query);
    EXPECT_EQ(run.found.size(), run.result.pair_count + run.result.near_count);
    EXPECT_GT(run.result.near_count, 0u);
    EXPECT_GT(run.result.pair_count, 0u);
}

} // namespace cd::tests
