// Proves that the box test loses no touching pair, however near to touching, crooked, skewed or
// distant the boxes are: in exact terms, with every kind of pose; nor a pair of boxes within a
// reach. Also proves that its bounds are needed: the search finds a test with smaller bounds wrong.

#include "common/geometry/reach.hpp"
#include "common/tree/box_test.hpp"
#include "tests/common/tree/exact_box.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

/// Two boxes and poses for them.
struct Boxes {
    ObbNode a;
    ObbNode b;
    PosePair poses;
    double clearance = 0; ///< In the world: boxes at most so far apart are near.
};

/// Makes boxes that touch up to some roundings.
Boxes touching_boxes(SeededRandom& random) {
    const auto [size, offset] = settings[random.seed % settings.size()];
    const ObbNode a = crooked_node(random, size, offset);
    const ObbNode b = crooked_node(random, size, offset);
    return {a, b, touching_poses(random, a, b, offset)};
}

bool is_rejected(const Boxes& boxes, double error_scale) {
    const double reach = body_reach(boxes.poses, boxes.clearance);
    return !BoxTest(relative_pose(boxes.poses), error_scale, reach).may_overlap(boxes.a, boxes.b);
}

Boxes moved(const Boxes& boxes, const Vec3& by) {
    Boxes there = boxes;
    there.poses.b = with_translation(boxes.poses.b, boxes.poses.b.translation() + by);
    return there;
}

/// True if the boxes overlap once B is moved by a vector, which is proven to be at most as long as
/// the clearance.
bool are_proven_near(const Boxes& boxes, const Vec3& by) {
    const Boxes there = moved(boxes, by);
    const ExactVec way = exact(there.poses.b.translation()) +
                         scaled(Rational(-1), exact(boxes.poses.b.translation()));
    const Rational clearance(boxes.clearance);
    return dot(way, way) <= clearance * clearance && exactly_overlap(there.a, there.b, there.poses);
}

void count_rejected(const Boxes& boxes, const Vec3& towards_a, Tally& tally) {
    ++tally.rejected;
    const Vec3 back = boxes.clearance / towards_a.norm() * towards_a;
    const bool is_lost =
        are_proven_near(boxes, Vec3::Zero()) || are_proven_near(boxes, (1 - 0x1p-20) * back);
    tally.lost += is_lost ? 1 : 0;
}

Vec3 from_a_to_b(const Boxes& boxes) {
    return boxes.poses.b.apply(center_point(boxes.b)) - boxes.poses.a.apply(center_point(boxes.a));
}

/// Tests boxes that touch up to some roundings.
Tally search_touching(double error_scale, std::uint64_t rounds) {
    Tally tally;
    for (SeededRandom random : seeds(rounds)) {
        const Boxes boxes = touching_boxes(random);
        if (is_rejected(boxes, error_scale)) {
            count_rejected(boxes, -from_a_to_b(boxes), tally);
        }
    }
    return tally;
}

/// Moves B away from touching until the test just rejects. The clearance is a share of the boxes'
/// size.
Tally search_brinks(double error_scale, std::uint64_t rounds, double clearance = 0) {
    Tally tally;
    for (SeededRandom random : seeds(rounds)) {
        Boxes touching = touching_boxes(random);
        touching.clearance = clearance * settings[random.seed % settings.size()].size;
        const Vec3 apart = from_a_to_b(touching);
        double near = -0.5;
        double far = 64;
        if (is_rejected(moved(touching, near * apart), error_scale) ||
            !is_rejected(moved(touching, far * apart), error_scale)) {
            continue; // The error exceeds the boxes.
        }
        for (int i = 0; i < 64; ++i) {
            const double middle = 0.5 * near + 0.5 * far;
            (is_rejected(moved(touching, middle * apart), error_scale) ? far : near) = middle;
        }
        count_rejected(moved(touching, far * apart), -apart, tally);
    }
    return tally;
}

/// Maps a point of B to A's body coordinates.
ExactVec seen_from_a(const Vec3& point, const PosePair& poses) {
    const ExactVec world = exact_rotation(poses.b) * exact(point) + exact(poses.b.translation());
    return inverse(exact_rotation(poses.a)) *
           (world + scaled(Rational(-1), exact(poses.a.translation())));
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
    for (SeededRandom random : seeds(rounds)) {
        const Setting setting = settings[random.seed % settings.size()];
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

/// The reach itself is taken a little larger than it is, so only small ones show rounding errors.
TEST(BoxBounds, BoxesWithinAReachAreNotLostButSomeAreWithSmallerBounds) {
    for (const double clearance : {0x1p-54, 0x1p-52}) {
        EXPECT_EQ(search_brinks(1, 200, clearance).lost, 0);
        EXPECT_GT(search_brinks(0.03, 300, clearance).lost, 0);
    }
    const Tally far = search_brinks(1, 200, 0.25);
    EXPECT_EQ(far.lost, 0);
    EXPECT_GT(far.rejected, 100);
}

TEST(BoxBounds, ATriangleSeenFromTheOtherBodyStaysInItsBounds) {
    EXPECT_EQ(search_triangle_bounds(1, 500), 0);
    EXPECT_GT(search_triangle_bounds(0, 100), 5);
    EXPECT_GT(search_triangle_bounds(0.03, 300), 0);
}

TEST(BoxBounds, BoxesMayOverlapWhereNumbersOverflow) {
    std::mt19937_64 random(1);
    const ObbNode node = crooked_node(random, 1, 1);
    const double big = 1.7e308;
    for (const PosePair& poses :
         {PosePair{translation_pose(big, 0, 0), translation_pose(-big, big, 0)},
          PosePair{make_pose(random, big), make_matrix_pose(random, big)},
          PosePair{Pose{}, Pose::from_matrix(big * Mat3::Identity(), Vec3(1, 2, 3))},
          PosePair{Pose::from_matrix(Mat3::Zero(), Vec3::Zero()), Pose{}}}) {
        const BoxTest test(relative_pose(poses));
        EXPECT_TRUE(test.may_overlap(node, node));
    }
}

} // namespace

} // namespace cd::tests
