// Proves that the distance of two bodies has one record for whole trees and for subtrees of any
// cut, and that roots that a scenario does not name cannot have the nearest pair.

#include "common/distance/triangle_distance.hpp"
#include "common/job/query_roots.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/common/job/in_parts.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>
#include <random>
#include <vector>

namespace cd::tests {

namespace {

Query distance_query(std::optional<double> up_to = std::nullopt) {
    Query query = query_of(Level::Any);
    query.question = Question::Distance;
    query.up_to = up_to;
    return query;
}

ScenarioResult distance_of(const ObbTree& a, const ObbTree& b, const PosePair& poses) {
    return run_scenario(a, b, make_scenario(poses), distance_query()).result;
}

} // namespace

TEST(DistanceScenario, PartsGiveTheSameRecordAsTheWhole) {
    std::mt19937_64 random(9);
    std::vector<ObbTree> trees;
    trees.push_back(make_tree(make_sphere(2)));
    trees.push_back(make_tree(make_gridded_box(Vec3(1.5, 1, 1), 4)));
    trees.push_back(make_tree(make_triangle_soup(random, 60)));
    trees.push_back(make_tree(make_degenerate_soup(random, 40)));
    std::map<ScenarioClass, int> classes;
    std::size_t with_distance = 0;
    for (int round = 0; round < 120; ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        const ObbTree& a = trees[random() % trees.size()];
        const ObbTree& b = trees[random() % trees.size()];
        const Pose pose_a = make_pose(random, 0.2);
        const PosePair poses{
            pose_a, random() % 2 == 0 ? make_pose(random, 4) : make_matrix_pose(random, 4)};
        const Scenario scenario = make_scenario(poses, 17);
        const bool is_wide = suits_wide_tree(a.view()) && suits_wide_tree(b.view());
        const Query query = random() % 3 == 0 ? distance_query(0.5) : distance_query();
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
        EXPECT_EQ(decoded.value().nearest, whole.nearest);
        EXPECT_FALSE(whole.nearest && whole.kind == ScenarioClass::Contact);
        EXPECT_FALSE(whole.nearest && query.up_to && whole.nearest->distance > *query.up_to);
        ++classes[whole.kind];
        with_distance += whole.nearest ? 1 : 0;
    }
    EXPECT_GT(classes[ScenarioClass::Separate], 20);
    EXPECT_GT(classes[ScenarioClass::Contact], 4);
    EXPECT_GT(with_distance, 20u);
}

TEST(DistanceScenario, TheWitnessHasTheNearestPointsOfItsPair) {
    const ObbTree sphere = make_tree(make_sphere(2));
    const PosePair poses{Pose::from_quaternion({2, 1, 0, 3}, Vec3(5, 5, 5)),
                         Pose::from_quaternion({1, 1, 0, 0}, Vec3(8, 5.5, 5))};
    const ScenarioResult result = distance_of(sphere, sphere, poses);
    EXPECT_EQ(result.kind, ScenarioClass::Separate);
    ASSERT_TRUE(result.nearest);
    TriangleDistance distance(poses, DistanceStage::Exact);
    const Corners a = sphere.mesh().corners(result.nearest->a);
    const Corners b = sphere.mesh().corners(result.nearest->b);
    EXPECT_EQ(result.nearest->distance, distance.rounded(a, b));
    const NearestPoints points = distance.nearest(a, b);
    EXPECT_EQ(result.nearest->feature, points.feature);
    EXPECT_EQ(result.nearest->origin, points.origin);
    EXPECT_EQ(result.nearest->point_a, points.of_a);
    EXPECT_EQ(result.nearest->point_b, points.of_b);
}

TEST(DistanceScenario, SwappedBodiesHaveTheSameDistance) {
    const ObbTree sphere = make_tree(make_sphere(3));
    const ObbTree box = make_tree(make_gridded_box(Vec3(1, 2, 0.5), 6));
    for (SeededRandom random : seeds(20)) {
        const PosePair poses{make_pose(random, 0.1),
                             with_translation(make_pose(random, 1), Vec3(3, 1, 0))};
        const auto one = distance_of(sphere, box, poses).nearest;
        const auto other = distance_of(box, sphere, {poses.b, poses.a}).nearest;
        ASSERT_TRUE(one && other);
        EXPECT_EQ(one->distance, other->distance);
    }
}

TEST(DistanceScenario, ABodyInsideAnotherHasADistance) {
    const ObbTree large = make_tree(make_gridded_box(Vec3(2, 2, 2), 4));
    const ObbTree small = make_tree(make_box(Vec3(1.5, 1, 1)));
    const ScenarioResult result = distance_of(large, small, PosePair{});
    EXPECT_EQ(result.kind, ScenarioClass::Inside);
    ASSERT_TRUE(result.nearest);
    EXPECT_EQ(result.nearest->distance, 0.25);
}

TEST(DistanceScenario, BodiesBeyondTheLimitHaveNoDistance) {
    const ObbTree box = make_tree(make_box(Vec3(1, 1, 1)));
    const Scenario scenario = make_scenario({Pose{}, translation_pose(1.5, 0, 0)});
    const auto at = run_scenario(box, box, scenario, distance_query(0.5)).result;
    ASSERT_TRUE(at.nearest);
    EXPECT_EQ(at.nearest->distance, 0.5);
    const auto beyond = run_scenario(box, box, scenario, distance_query(0.499)).result;
    EXPECT_EQ(beyond.kind, ScenarioClass::Separate);
    EXPECT_FALSE(beyond.nearest);
}

TEST(DistanceScenario, FewRootsOfBodiesFarApartAreNamed) {
    const ObbTree sphere = make_tree(make_sphere(4));
    const TreeTop top = cut_tree(sphere, 8);
    const Scenario scenario = make_scenario({Pose{}, translation_pose(10, 0, 0)});
    const auto roots = query_roots(top, top, scenario, distance_query()).value().pairs;
    EXPECT_FALSE(roots.empty());
    EXPECT_LT(roots.size(), std::size_t{top.root_count()} * top.root_count() / 10);
    Query ignoring = distance_query();
    ignoring.ignored = {{0, 1, 0, 1}};
    EXPECT_EQ(query_roots(top, top, scenario, ignoring).value().pairs.size(),
              std::size_t{top.root_count()} * top.root_count());
    ignoring.ignored = {{0, 1, 0, 1, 1, 2}}; // Of other bodies.
    EXPECT_EQ(query_roots(top, top, scenario, ignoring).value().pairs, roots);
}

} // namespace cd::tests
