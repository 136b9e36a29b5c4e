// Proves that the box test loses no touching pair, however near to touching, crooked, skewed or
// distant the boxes are: in exact terms, with every kind of pose. Also proves that its bounds are
// needed: the search finds a test with smaller bounds wrong.

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
};

/// Makes boxes that touch up to some roundings.
Boxes touching_boxes(SeededRandom& random) {
    const auto [size, offset] = settings[random.seed % settings.size()];
    const ObbNode a = crooked_node(random, size, offset);
    const ObbNode b = crooked_node(random, size, offset);
    return {a, b, touching_poses(random, a, b, offset)};
}

bool is_rejected(const Boxes& boxes, double error_scale) {
    return !BoxTest(relative_pose(boxes.poses), error_scale).may_overlap(boxes.a, boxes.b);
}

void count_rejected(const Boxes& boxes, Tally& tally) {
    ++tally.rejected;
    tally.lost += exactly_overlap(boxes.a, boxes.b, boxes.poses) ? 1 : 0;
}

/// Tests boxes that touch up to some roundings.
Tally search_touching(double error_scale, std::uint64_t rounds) {
    Tally tally;
    for (SeededRandom random : seeds(rounds)) {
        const Boxes boxes = touching_boxes(random);
        if (is_rejected(boxes, error_scale)) {
            count_rejected(boxes, tally);
        }
    }
    return tally;
}

/// Moves B away from touching until the test just rejects.
Tally search_brinks(double error_scale, std::uint64_t rounds) {
    Tally tally;
    for (SeededRandom random : seeds(rounds)) {
        const Boxes touching = touching_boxes(random);
        const PosePair& at = touching.poses;
        const Vec3 apart =
            at.b.apply(center_point(touching.b)) - at.a.apply(center_point(touching.a));
        const auto moved = [&](double share) {
            const Vec3 place = at.b.translation() + share * apart;
            return Boxes{touching.a, touching.b, {at.a, with_translation(at.b, place)}};
        };
        double near = -0.5;
        double far = 64;
        if (is_rejected(moved(near), error_scale) || !is_rejected(moved(far), error_scale)) {
            continue; // The error exceeds the boxes.
        }
        for (int i = 0; i < 64; ++i) {
            const double middle = 0.5 * near + 0.5 * far;
            (is_rejected(moved(middle), error_scale) ? far : near) = middle;
        }
        count_rejected(moved(far), tally);
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
