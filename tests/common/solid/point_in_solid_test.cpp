// Proves that a position right beside a surface point is classified as a slightly moved point would
// be, and that the solid's side is found for any winding.
#include "common/solid/point_in_solid.hpp"

#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <array>

namespace cd::tests {

namespace {

SolidPoint exact_point(const Vec3& at) {
    return {at, 0, [at] { return ExactPoint{{to_dyadic(at)}, Dyadic{1, 0}}; }};
}

/// Returns the triangles that hold the point, of a cube with corners at -1 and 1.
std::vector<std::uint32_t> holders(const Mesh& cube, const Vec3& point) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < cube.triangles().size(); ++i) {
        const Corners corners = cube.corners(i);
        for (int axis = 0; axis < 3; ++axis) {
            const double level = corners[0][axis];
            // All triangles of a face in the point's plane count as holders.
            if (corners[1][axis] == level && corners[2][axis] == level && point[axis] == level) {
                found.push_back(i);
            }
        }
    }
    return found;
}

} // namespace

TEST(PointInSolid, BesideASurfacePointEqualsASmallStepAway) {
    for (const bool inside_out : {false, true}) {
        const Mesh mesh = make_gridded_box(Vec3(2, 2, 2), 3);
        const ObbTree tree = make_tree(inside_out ? reversed(mesh) : mesh);
        SolidTest solid(tree);
        int inside = 0;
        int outside = 0;
        // Points of faces, edges and corners, with a plane above which no holder reaches, and with
        // the planes of the faces, which no holder leaves.
        for (const Vec3& at : {Vec3(1, 0.25, -0.5),
                               Vec3(1, -1, 0.125),
                               Vec3(1, 1, 1),
                               Vec3(-1, 1. / 3, 1. / 3),
                               Vec3(0, -1, -1)}) {
            Vec3 normal = Vec3::Zero();
            for (int axis = 0; axis < 3; ++axis) {
                normal[axis] = std::abs(at[axis]) == 1 ? at[axis] : 0;
            }
            const auto side_of = [&](const Vec3& direction) {
                return sign_of(direction.dot(normal));
            };
            const std::vector<std::uint32_t> passed_over = holders(tree.mesh(), at);
            SolidPoint point = exact_point(at);
            EXPECT_EQ(solid.locate(point), Location::OnSurface);
            EXPECT_FALSE(solid.is_inside_beside(point, side_of, 1, passed_over));
            ++outside;
            if (normal.cwiseAbs().sum() == 1) {
                EXPECT_TRUE(solid.is_inside_beside(point, side_of, -1, passed_over));
                ++inside;
            }
        }
        EXPECT_GT(inside, 1);
        EXPECT_GT(outside, 3);
    }
}

TEST(PointInSolid, TheSolidLiesBehindATriangleOrInFrontOfAReversedOne) {
    const Mesh sphere = make_sphere(3);
    const ObbTree outward = make_tree(sphere);
    const ObbTree inward = make_tree(reversed(sphere));
    SolidTest solid(outward);
    SolidTest hollow(inward);
    const int behind = solid.solid_side(0);
    EXPECT_NE(behind, 0);
    for (std::uint32_t i = 0; i < sphere.triangles().size(); ++i) {
        EXPECT_EQ(solid.solid_side(i), behind);
        EXPECT_EQ(hollow.solid_side(i), -behind);
    }
}

} // namespace cd::tests
