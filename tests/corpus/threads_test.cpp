// Rebuilds, with our own numbers, situations that users of other projects reported as wrong. Each
// test is named after the report.
#include "common/job/run_scenario.hpp"
#include "tests/corpus/solids.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/scene_oracle.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace cd::tests {

namespace {

ScenarioResult run(const Mesh& a, const Mesh& b, const PosePair& poses, Level level) {
    return run_scenario(make_tree(a), make_tree(b), make_scenario(poses), query_of(level)).result;
}

/// Expects no contact in any order of corners and bodies.
void expect_apart(const Corners& a, const Corners& b) {
    ASSERT_EQ(oracle_class(a, b, {}), PairClass::Separate);
    for (std::size_t i = 0; i < 3; ++i) {
        const Corners turned{a[i], a[(i + 1) % 3], a[(i + 2) % 3]};
        const Corners flipped{b[(i + 2) % 3], b[(i + 1) % 3], b[i]};
        EXPECT_EQ(TrianglePairTest({}).classify(turned, flipped), PairClass::Separate);
        EXPECT_EQ(TrianglePairTest({}).classify(flipped, turned), PairClass::Separate);
    }
}

} // namespace

// Report: two triangles of one upright wall, with corners on two plumb lines and once floats,
// counted as meeting. Rounded normals put them in two planes, and a tolerance did the rest.
TEST(Threads, TrianglesOfOneUprightWallStayApart) {
    const auto at = [](bool second, float height) {
        return second ? Vec3(double{17.418531f}, double{41.269943f}, double{height})
                      : Vec3(double{17.437866f}, double{41.227783f}, double{height});
    };
    const Corners lower{at(false, 0.7f), at(true, 0.6f), at(false, 0.6f)};
    const Corners upper{at(true, 0.8f), at(true, 0.7f), at(false, 0.8f)};
    expect_apart(lower, upper);
    // Moved down until the edges are on one line, they meet even without a tolerance.
    const Corners meeting{at(true, 0.6f), at(true, 0.5f), at(false, 0.7f)};
    EXPECT_EQ(TrianglePairTest({}).classify(lower, meeting), oracle_class(lower, meeting, {}));
    EXPECT_NE(oracle_class(lower, meeting, {}), PairClass::Separate);
}

// Report: two walls of one profile on one axis overlap by 50 mm, and no clash was found. Every
// corner of each is on a face of the other, and all crossing edges are in shared planes.
TEST(Threads, OverlappingWallsOfOneProfileCollide) {
    const Mesh wall = make_box_between(Vec3(0, 0, 0), Vec3(3, 0.25, 2.5));
    const Mesh corner = make_box_between(Vec3(0, 0, 0), Vec3(0.25, 3, 2.5));
    const PosePair along{Pose{}, translation_pose(2.95, 0, 0)};
    const PosePair around{Pose{}, translation_pose(2.95, -0.05, 0)};
    for (const auto& [b, poses] : {std::pair(wall, along), std::pair(corner, around)}) {
        const SceneOracle oracle(wall, b, poses);
        EXPECT_EQ(oracle.scenario_class(true), ScenarioClass::Cross);
        EXPECT_EQ(run(wall, b, poses, Level::Pairs).pairs, oracle.contact_pairs());
        EXPECT_EQ(run(wall, b, poses, Level::Any).kind, ScenarioClass::Contact);
    }
    // Placed end to end, they only touch.
    const SceneOracle end_to_end(wall, wall, {Pose{}, translation_pose(3, 0, 0)});
    EXPECT_EQ(end_to_end.scenario_class(true), ScenarioClass::Touch);
}

// Report: flat meshes counted as self-intersecting, since coplanar but separate triangles were
// found to meet.
TEST(Threads, CoplanarSeparateTrianglesDoNotIntersect) {
    const auto at = [](double y, double z) { return Vec3(0, y, z); };
    expect_apart({at(0.14, 1), at(0, 1.13), at(0, 1.03)}, {at(1.13, 0), at(0.03, 1), at(1.03, 0)});
    expect_apart({at(0.1, 0.1), at(0.7, 0.1), at(0.1, 0.7)},
                 {at(0.7, 0.2), at(0.7, 0.7), at(0.2, 0.7)});
    expect_apart({Vec3(0.1, 0.2, 0.3), Vec3(0.4, 0.2, 0.3), Vec3(0.1, 0.5, 0.3)},
                 {Vec3(0.7, 0.2, 0.3), Vec3(0.9, 0.2, 0.3), Vec3(0.7, 0.5, 0.3)});
}

// Report: a box given as a mesh fell through another. We assume that only vertices were tested
// against the other mesh; then boxes that cross or rest with all vertices outside never collide.
TEST(Threads, BoxesCrossingWithoutInnerVerticesCollide) {
    const Mesh plate = make_box_between(Vec3(-10, -10, -1), Vec3(10, 10, 0));
    const Mesh pillar = make_box_between(Vec3(-1, -1, -20), Vec3(1, 1, 20));
    EXPECT_EQ(run(plate, pillar, {}, Level::Count).kind, ScenarioClass::Cross);
    const Mesh cube = make_box_between(Vec3(-1, -1, -1), Vec3(1, 1, 1));
    for (const double height : {1.0, 1 + 0x1p-52}) {
        const PosePair poses{Pose{}, translation_pose(0.3, 0.2, height)};
        const auto found = run(plate, cube, poses, Level::Pairs);
        EXPECT_EQ(found.pairs, SceneOracle(plate, cube, poses).contact_pairs());
        EXPECT_EQ(found.kind, height == 1 ? ScenarioClass::Touch : ScenarioClass::Separate);
    }
}

// Report: for a small box on a large one, the contact points were corners of the large box's
// triangles, far outside the shared face.
TEST(Threads, ContactPointsLieInTheSharedFaceOfStackedBoxes) {
    const Mesh large = make_box_between(Vec3(-2, -2, -1), Vec3(2, 2, 0));
    const Mesh small = make_box_between(Vec3(-0.5, -0.25, 0), Vec3(0.5, 0.25, 1));
    const ScenarioResult result = run(large, small, {}, Level::Contacts);
    ASSERT_EQ(result.kind, ScenarioClass::Touch);
    std::set<std::tuple<double, double>> corners;
    for (std::size_t pair = 0; pair < result.pairs.size(); ++pair) {
        for (std::uint32_t i = result.point_offsets[pair]; i < result.point_offsets[pair + 1];
             ++i) {
            const Vec3 point = result.point_origins[pair] + result.points[i];
            EXPECT_LE(std::abs(point.x()), 0.5);
            EXPECT_LE(std::abs(point.y()), 0.25);
            EXPECT_EQ(point.z(), 0);
            if (std::abs(point.x()) == 0.5 && std::abs(point.y()) == 0.25) {
                corners.emplace(point.x(), point.y());
            }
        }
    }
    EXPECT_EQ(corners.size(), 4u);
}

// Report: for two stacked boxes the box tests, rounding without a margin, lost three quarters of
// the touching pairs: touching flat boxes were found apart.
TEST(Threads, BoxTestsKeepAllTouchingPairsOfStackedBoxes) {
    const Mesh box = make_ticked_box(ticks(0, 0.1, 6), ticks(0, 0.1, 6), ticks(0, 0.1, 6));
    const Quaternion turn{7, 1, -3, 2};
    const Vec3 place(0.1, 20.3, -7.7);
    // Rounds that height above the turned box, in its own direction: (R z) * height.
    const Vec3 up = Pose::from_quaternion(turn, Vec3::Zero()).apply(Vec3(0, 0, 0.6));
    const Mesh upper = make_ticked_box(ticks(0, 0.1, 6), ticks(0, 0.1, 6), ticks(6 * 0.1, 0.1, 6));
    const Pose pose = Pose::from_quaternion(turn, place);
    const Pose rounded = Pose::from_matrix(pose.rotation(), pose.translation());
    const std::size_t flat = SceneOracle(box, upper, {}).contact_pairs().size();
    EXPECT_GT(flat, 1000u);
    for (const PosePair& poses : {PosePair{}, PosePair{pose, pose}, PosePair{rounded, rounded}}) {
        const SceneOracle oracle(box, upper, poses);
        // One pose for both bodies keeps every contact.
        EXPECT_EQ(oracle.contact_pairs().size(), flat);
        EXPECT_EQ(run(box, upper, poses, Level::Pairs).pairs, oracle.contact_pairs());
    }
    const PosePair stacked{pose, Pose::from_quaternion(turn, place + up)};
    EXPECT_EQ(run(box, box, stacked, Level::Pairs).pairs,
              SceneOracle(box, box, stacked).contact_pairs());
}

} // namespace cd::tests
