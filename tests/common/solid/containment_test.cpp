// Proves that containment is decided exactly: nested and separate bodies, cavities, rays through
// edges and corners, gaps of one ulp, and agreement with known geometry.

#include "common/solid/containment.hpp"

#include "tests/support/rounds.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cd::tests {

namespace {

/// Makes a body that is a single point.
ObbTree make_point(const Vec3& at) {
    return make_tree(make_mesh({at}, {Triangle{0, 0, 0}}));
}

bool contains(const ObbTree& outer,
              const Pose& outer_pose,
              const ObbTree& inner,
              const Pose& inner_pose) {
    SettleStatistics statistics;
    const InsideProbes probes = inside_probes(inner, outer, {});
    return contains_component(outer, outer_pose, inner, inner_pose, probes, statistics);
}

bool contains(const ObbTree& outer, const ObbTree& inner, const Pose& inner_pose = Pose{}) {
    return contains(outer, Pose{}, inner, inner_pose);
}

} // namespace

TEST(Containment, ASmallSphereIsInsideALargeOneAndNotTheOtherWayRound) {
    const ObbTree large = make_tree(make_sphere(3));
    const ObbTree small = make_tree(scaled(make_sphere(2), 0.25));
    EXPECT_TRUE(contains(large, small));
    EXPECT_FALSE(contains(small, large));
    EXPECT_TRUE(contains(large, small, translation_pose(0.5, 0, 0)));
    EXPECT_FALSE(contains(large, small, translation_pose(1.5, 0, 0)));
    // The small one is in the large one's box, but not inside.
    EXPECT_FALSE(contains(large, small, translation_pose(0.85, 0.85, 0.85)));
    EXPECT_FALSE(contains(large, small, translation_pose(100, 0, 0)));
}

TEST(Containment, OneComponentInsideIsEnough) {
    const ObbTree box = make_tree(make_box(Vec3(2, 2, 2)));
    const Mesh dot = make_box(Vec3(0.1, 0.1, 0.1));
    const ObbTree one_in =
        make_tree(join({translated(dot, Vec3(5, 0, 0)), translated(dot, Vec3(0.3, 0.2, 0.1))}));
    const ObbTree none_in =
        make_tree(join({translated(dot, Vec3(5, 0, 0)), translated(dot, Vec3(0, -3, 0))}));
    EXPECT_TRUE(contains(box, one_in));
    EXPECT_FALSE(contains(box, none_in));
}

TEST(Containment, ACavityIsOutside) {
    const Mesh shell = join({make_sphere(3), reversed(scaled(make_sphere(3), 0.5))});
    const ObbTree hollow = make_tree(shell);
    EXPECT_FALSE(contains(hollow, make_point(Vec3(0, 0, 0))));
    EXPECT_FALSE(contains(hollow, make_point(Vec3(0.3, 0.1, 0.2))));
    EXPECT_TRUE(contains(hollow, make_point(Vec3(0.7, 0.1, 0.1))));
    EXPECT_FALSE(contains(hollow, make_point(Vec3(0.7, 0.7, 0.7))));
}

TEST(Containment, ATorusHasAHole) {
    const ObbTree torus = make_tree(make_torus(1.0, 0.25, 24, 12));
    EXPECT_FALSE(contains(torus, make_point(Vec3(0, 0, 0))));
    EXPECT_TRUE(contains(torus, make_point(Vec3(1, 0.01, 0))));
    EXPECT_TRUE(contains(torus, make_point(Vec3(0, -1, 0))));
    EXPECT_FALSE(contains(torus, make_point(Vec3(0, 0, 0.2))));
}

TEST(Containment, PointsOnTheSurfaceAreNotInside) {
    const ObbTree box = make_tree(make_gridded_box(Vec3(2, 2, 2), 4));
    // A corner, a vertex of the grid, points of an edge and of a face.
    for (const Vec3& point :
         {Vec3(1, 1, 1), Vec3(1, 0.5, 0.5), Vec3(-1, 0.25, 0.5), Vec3(0.125, 0.0625, 1)}) {
        EXPECT_FALSE(contains(box, make_point(point))) << point.transpose();
    }
}

TEST(Containment, OneUnitInTheLastPlaceDecides) {
    const ObbTree box = make_tree(make_gridded_box(Vec3(2, 2, 2), 4));
    const double in = std::nextafter(1.0, 0.0);
    const double out = std::nextafter(1.0, 2.0);
    EXPECT_TRUE(contains(box, make_point(Vec3(in, in, in))));
    EXPECT_TRUE(contains(box, make_point(Vec3(-in, 0.5, 0.25))));
    EXPECT_FALSE(contains(box, make_point(Vec3(out, 0.5, 0.25))));
    EXPECT_FALSE(contains(box, make_point(Vec3(0.5, -out, 0))));

    // The exact sum 0.1 + 0.2 lies between the double 0.3 and the rounded sum: the pose's
    // translation must be added without rounding.
    const auto cube_to = [](double reach) {
        return make_tree(make_box(Vec3(2 * reach, 2 * reach, 2 * reach)));
    };
    const ObbTree point = make_point(Vec3(0.1, 0, 0));
    EXPECT_FALSE(contains(cube_to(0.3), point, translation_pose(0.2, 0, 0)));
    EXPECT_TRUE(contains(cube_to(0.1 + 0.2), point, translation_pose(0.2, 0, 0)));
}

TEST(Containment, QuaternionsAreTakenAsRationals) {
    // (1, 1/3, 0, 0) is no unit quaternion; turned about x, the point keeps its x exactly.
    const Pose turned = Pose::from_quaternion({3, 1, 0, 0}, Vec3::Zero());
    const ObbTree box = make_tree(make_box(Vec3(2, 20, 20)));
    EXPECT_FALSE(contains(box, make_point(Vec3(1, 1, 2)), turned));
    EXPECT_TRUE(contains(box, make_point(Vec3(std::nextafter(1.0, 0.0), 1, 2)), turned));
    // A 3-4-5 turn moves (0, 5, 0) to (0, 4, 3), which is on the face of this box.
    const ObbTree flat = make_tree(make_box(Vec3(2, 8, 20)));
    EXPECT_FALSE(contains(flat, make_point(Vec3(0, 5, 0)), turned));
    EXPECT_TRUE(contains(flat, make_point(Vec3(0, std::nextafter(5.0, 0.0), 0)), turned));
    // The outer body turned back instead.
    const Pose back = Pose::from_quaternion({3, -1, 0, 0}, Vec3(7, 7, 7));
    const Pose there = translation_pose(7, 7, 7);
    EXPECT_FALSE(contains(flat, back, make_point(Vec3(0, 5, 0)), there));
    EXPECT_TRUE(contains(flat, back, make_point(Vec3(0, std::nextafter(5.0, 0.0), 0)), there));
}

TEST(Containment, AgreesWithTheDefinitionOfABoxUnderRandomPoses) {
    const ObbTree box = make_tree(make_gridded_box(Vec3(2, 2, 2), 3));
    int inside = 0;
    for (SeededRandom random : seeds(400)) {
        const Vec3 at = random_point(random, 1.3);
        const bool expected = at.cwiseAbs().maxCoeff() < 1;
        // Both bodies move together, so the point keeps its distance from the faces.
        const Pose pose =
            random.seed % 2 == 0 ? make_pose(random, 10) : make_matrix_pose(random, 10);
        ASSERT_EQ(contains(box, pose, make_point(at), pose), expected);
        inside += expected ? 1 : 0;
    }
    EXPECT_GT(inside, 100);
    EXPECT_LT(inside, 300);
}

TEST(Containment, GridPointsOfAGriddedBoxHaveManyDegenerateRays) {
    const ObbTree box = make_tree(make_gridded_box(Vec3(2, 2, 2), 8));
    for (int x = -5; x <= 5; ++x) {
        for (int y = -5; y <= 5; ++y) {
            const bool expected = std::abs(x) < 4 && std::abs(y) < 4;
            ASSERT_EQ(contains(box, make_point(Vec3(x, y, 1) / 4)), expected) << x << ' ' << y;
        }
    }
}

TEST(Containment, RaysThroughEdgesAreCastAgain) {
    // The first attempt's ray from the origin has the direction (1, t, t^2).
    const double t = 26177.0 / 65536;
    const Vec3 tip(1, t, t * t);
    // A tetrahedron around the origin with this tip: the ray meets three triangles in a corner.
    const Mesh tetrahedron = make_mesh({tip, Vec3(-1, 1, 0), Vec3(-1, -1, 1), Vec3(-1, -1, -2)},
                                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
    EXPECT_TRUE(contains(make_tree(tetrahedron), make_point(Vec3(0, 0, 0))));
    EXPECT_FALSE(contains(make_tree(translated(tetrahedron, Vec3(2, 2 * t, 2 * t * t))),
                          make_point(Vec3(0, 0, 0))));
}

TEST(Containment, ExtremeCoordinatesAreDecided) {
    // At the last size every cross product of its edges underflows in double.
    for (const double size : {0x1p400, 0x1p-400, 0x1p-600}) {
        const ObbTree sphere = make_tree(scaled(make_sphere(1), size));
        EXPECT_TRUE(contains(sphere, make_point(Vec3(0x1p-10 * size, 0, 0)))) << size;
        EXPECT_FALSE(contains(sphere, make_point(Vec3(2 * size, 0, 0)))) << size;
    }
}

} // namespace cd::tests
