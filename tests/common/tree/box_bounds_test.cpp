// Proves that the box test loses no touching pair, however near to touching, crooked, skewed or
// distant the boxes are: in exact terms, with every kind of pose. Also proves that its bounds are
// needed: the search finds a test with smaller bounds wrong.

#include "common/tree/box_test.hpp"
#include "tests/common/tree/exact_box.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd::tests {

namespace {

struct Tally {
    int rejected = 0;
    int lost = 0; ///< Rejected although they share a point.
};

/// Sizes and distances of boxes: ordinary, small but distant, and tiny ones.
struct Setting {
    double size;
    double offset;
};
constexpr std::array<Setting, 4> settings{{{1, 1}, {1e-3, 1e7}, {1e6, 1e-6}, {1e-20, 1e-3}}};

/// Tests boxes that touch up to some roundings.
Tally search_touching(double error_scale, std::uint64_t rounds) {
    Tally tally;
    for (std::uint64_t seed = 0; seed < rounds; ++seed) {
        std::mt19937_64 random(seed);
        const Setting setting = settings[seed % settings.size()];
        const ObbNode a = crooked_node(random, setting.size, setting.offset);
        const ObbNode b = crooked_node(random, setting.size, setting.offset);
        const PosePair poses = touching_poses(random, a, b, setting.offset);
        if (!BoxTest(relative_pose(poses), error_scale).may_overlap(a, b)) {
            ++tally.rejected;
            tally.lost += exactly_overlap(exact_box(a, poses.a), exact_box(b, poses.b)) ? 1 : 0;
        }
    }
    return tally;
}

/// Moves B away from touching until the test just rejects.
Tally search_brinks(double error_scale, std::uint64_t rounds) {
    Tally tally;
    for (std::uint64_t seed = 0; seed < rounds; ++seed) {
        std::mt19937_64 random(seed);
        const Setting setting = settings[seed % settings.size()];
        const ObbNode a = crooked_node(random, setting.size, setting.offset);
        const ObbNode b = crooked_node(random, setting.size, setting.offset);
        const PosePair touching = touching_poses(random, a, b, setting.offset);
        const auto center = [](const ObbNode& node) {
            return Vec3(node.center[0], node.center[1], node.center[2]);
        };
        const Vec3 apart = touching.b.apply(center(b)) - touching.a.apply(center(a));
        const auto poses_at = [&](double share) {
            return PosePair{touching.a,
                            with_translation(touching.b, touching.b.translation() + share * apart)};
        };
        const auto kept = [&](double share) {
            return BoxTest(relative_pose(poses_at(share)), error_scale).may_overlap(a, b);
        };
        double near = -0.5;
        double far = 64;
        if (!kept(near) || kept(far)) {
            continue; // The error exceeds the boxes.
        }
        for (int i = 0; i < 64; ++i) {
            const double middle = 0.5 * near + 0.5 * far;
            (kept(middle) ? near : far) = middle;
        }
        const PosePair poses = poses_at(far);
        ++tally.rejected;
        tally.lost += exactly_overlap(exact_box(a, poses.a), exact_box(b, poses.b)) ? 1 : 0;
    }
    return tally;
}

Rational determinant(const ExactMat& m) {
    return dot(m[0], cross(m[1], m[2]));
}

/// Maps a point of B to A's body coordinates.
ExactVec seen_from_a(const Vec3& point, const PosePair& poses) {
    const ExactMat a = exact_rotation(poses.a);
    const ExactVec world = exact_rotation(poses.b) * exact(point) + exact(poses.b.translation());
    const ExactVec from_a = world + scaled(Rational(-1), exact(poses.a.translation()));
    // Cramer's rule with the columns of A's matrix.
    const auto column = [&](std::size_t k) { return ExactVec{a[0][k], a[1][k], a[2][k]}; };
    const Rational whole = determinant(a);
    ExactVec seen;
    for (std::size_t k = 0; k < 3; ++k) {
        seen[k] = dot(from_a, cross(column((k + 1) % 3), column((k + 2) % 3))) / whole;
    }
    return seen;
}

bool holds(const Aabb& box, const ExactVec& point) {
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const bool low = !(box.min[axis] > -std::numeric_limits<double>::infinity()) ||
                         Rational(box.min[axis]) <= point[k];
        const bool high = !(box.max[axis] < std::numeric_limits<double>::infinity()) ||
                          point[k] <= Rational(box.max[axis]);
        if (!low || !high) {
            return false;
        }
    }
    return true;
}

/// Counts triangles of B whose box, seen from A, misses one of their corners.
int search_triangle_bounds(double error_scale, std::uint64_t rounds) {
    int lost = 0;
    for (std::uint64_t seed = 0; seed < rounds; ++seed) {
        std::mt19937_64 random(seed);
        const Setting setting = settings[seed % settings.size()];
        const PosePair poses{any_pose(random, setting.offset), any_pose(random, setting.offset)};
        const Vec3 place = random_point(random, setting.offset);
        Corners corners;
        for (Vec3& corner : corners) {
            corner = place + random_point(random, setting.size);
        }
        const Aabb box = BoxTest(relative_pose(poses), error_scale).bounds(corners);
        lost +=
            std::ranges::all_of(
                corners, [&](const Vec3& corner) { return holds(box, seen_from_a(corner, poses)); })
                ? 0
                : 1;
    }
    return lost;
}

/// Returns the exact corners of a box in body coordinates.
std::vector<ExactVec> corners_of(const ObbNode& node) {
    const ExactBox box = exact_box(node, Pose{});
    std::vector<ExactVec> corners;
    for (unsigned signs = 0; signs < 8; ++signs) {
        ExactVec corner = box.center;
        for (unsigned k = 0; k < 3; ++k) {
            corner = corner + scaled(Rational((signs >> k & 1) != 0 ? 1 : -1), box.edges[k]);
        }
        corners.push_back(corner);
    }
    return corners;
}

/// Returns the largest squared distance between points of the two boxes, in A's coordinates.
Rational squared_distance_max(const ObbNode& a, const ObbNode& b, const PosePair& poses) {
    // A's rotation is the identity, so only its translation separates its body from the world.
    Rational farthest = 0;
    const ExactMat turn = exact_rotation(poses.b);
    const ExactVec move =
        exact(poses.b.translation()) + scaled(Rational(-1), exact(poses.a.translation()));
    for (const ExactVec& y : corners_of(b)) {
        const ExactVec seen = turn * y + move;
        for (const ExactVec& x : corners_of(a)) {
            const ExactVec between = seen + scaled(Rational(-1), x);
            farthest = std::max(farthest, dot(between, between));
        }
    }
    return farthest;
}

TEST(BoxBounds, BoxesThatTouchButForRoundingsAreNotLost) {
    const Tally tally = search_touching(1, 1000);
    EXPECT_EQ(tally.lost, 0);
}

TEST(BoxBounds, WhereTheTestJustRejectsTheBoxesAreApart) {
    const Tally tally = search_brinks(1, 400);
    EXPECT_EQ(tally.lost, 0);
    EXPECT_GT(tally.rejected, 150); // Without rejections this proves little.
}

TEST(BoxBounds, SmallerBoundsLoseTouchingBoxes) {
    EXPECT_GT(search_touching(0, 400).lost, 5);
    EXPECT_GT(search_brinks(0, 60).lost, 5);
    EXPECT_GT(search_brinks(0.03, 200).lost, 0);
}

TEST(BoxBounds, ATriangleSeenFromTheOtherBodyStaysInItsBounds) {
    EXPECT_EQ(search_triangle_bounds(1, 500), 0);
    EXPECT_GT(search_triangle_bounds(0, 100), 5);
    EXPECT_GT(search_triangle_bounds(0.03, 300), 0);
}

TEST(BoxBounds, TheLargestDistanceOfTwoBoxesIsBounded) {
    int exceeded_without_bounds = 0;
    for (std::uint64_t seed = 0; seed < 80; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937_64 random(seed);
        const Setting setting = settings[seed % settings.size()];
        const ObbNode a = crooked_node(random, setting.size, setting.offset);
        ObbNode b = crooked_node(random, setting.size, setting.offset);
        PosePair poses = touching_poses(random, a, b, setting.offset);
        poses.a = translation_pose(0, 0, 0);
        if (seed % 2 == 0) {
            // The diagonals lie on one line, where the bound is nearly reached.
            b = a;
            poses.b = with_translation(Pose{}, Vec3::Zero());
            Vec3 diagonal = Vec3::Zero();
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 axis(a.axes[3 * k], a.axes[3 * k + 1], a.axes[3 * k + 2]);
                diagonal += static_cast<double>(a.half[k]) * axis;
            }
            const double stretch = 1 + 0x1p-15;
            poses.b = Pose::from_matrix(stretch * Mat3::Identity(), 2 * diagonal);
        }
        const auto bound = [&](double error_scale) {
            const BoxTest test(relative_pose(poses), error_scale);
            return test.distance_max(a, test.pose(b));
        };
        const Rational exact_square = squared_distance_max(a, b, poses);
        const double distance = bound(1);
        ASSERT_TRUE(std::isfinite(distance));
        ASSERT_LE(exact_square, Rational(distance) * Rational(distance));
        const double bare = bound(0);
        exceeded_without_bounds += exact_square > Rational(bare) * Rational(bare) ? 1 : 0;
    }
    EXPECT_GT(exceeded_without_bounds, 5);
}

TEST(BoxBounds, TheDistanceIsInfiniteNeverNaNWhereNumbersOverflow) {
    std::mt19937_64 random(1);
    const ObbNode node = crooked_node(random, 1, 1);
    const double big = 1.7e308;
    for (const PosePair& poses :
         {PosePair{translation_pose(big, 0, 0), translation_pose(-big, big, 0)},
          PosePair{make_pose(random, big), make_matrix_pose(random, big)},
          PosePair{Pose{}, Pose::from_matrix(big * Mat3::Identity(), Vec3(1, 2, 3))},
          PosePair{Pose::from_matrix(Mat3::Zero(), Vec3::Zero()), Pose{}}}) {
        const BoxTest test(relative_pose(poses));
        EXPECT_EQ(test.distance_max(node, test.pose(node)),
                  std::numeric_limits<double>::infinity());
        EXPECT_TRUE(test.may_overlap(node, node));
    }
}

} // namespace

} // namespace cd::tests
