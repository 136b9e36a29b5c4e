// Proves that the box test rejects boxes a small distance apart, keeps those that touch, bounds
// how far apart boxes are, and decides nothing where numbers overflow or poses are no rotations.

#include "common/tree/box_test.hpp"

#include "tests/common/tree/exact_box.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd::tests {

namespace {

/// Makes the box of a flat, long or round cloud, with a frame as the builder makes it.
ObbNode random_node(std::mt19937_64& random, double offset, double scale = 1) {
    const Vec3 stretch(uniform(random, 0, 1) < 0.3 ? 0 : 1,
                       uniform(random, 0, 1) < 0.3 ? 1e-3 : 1,
                       uniform(random, 0, 1) < 0.3 ? 50 : 1);
    const Mat3 turn = make_matrix_pose(random, 1).matrix();
    const Vec3 shift = random_point(random, offset);
    const Mesh cloud = mapped(make_triangle_soup(random, 6), [&](const Vec3& vertex) {
        return Vec3(scale * (turn * vertex.cwiseProduct(stretch)) + shift);
    });
    return make_tree(cloud, {.leaf_triangles_max = 8}).nodes()[0];
}

double least_distance(const ObbNode& a, const ObbNode& b, const PosePair& poses) {
    const BoxTest boxes(relative_pose(poses));
    return boxes.least_distance(a, boxes.pose(b));
}

bool may_overlap(const ObbNode& a, const ObbNode& b, const PosePair& poses) {
    return BoxTest(relative_pose(poses)).may_overlap(a, b);
}

Pose moved(const Pose& pose, const Vec3& by) {
    return with_translation(pose, pose.translation() + by);
}

double size_of(const ObbNode& node) {
    return static_cast<double>(node.half[0]) + static_cast<double>(node.half[1]) +
           static_cast<double>(node.half[2]);
}

/// Two poses of B on a line: one just not rejected, one just rejected.
struct PosedBrink {
    PosePair inside;
    PosePair outside;
    Vec3 direction;
};

PosedBrink find_brink(std::mt19937_64& random, const ObbNode& a, const ObbNode& b, double offset) {
    PosePair poses{make_pose(random, offset), make_pose(random, offset)};
    if (random() % 2 == 0) {
        poses = {make_matrix_pose(random, offset), make_matrix_pose(random, offset)};
    }
    // The centres coincide.
    poses.b = moved(poses.b, poses.a.apply(center_point(a)) - poses.b.apply(center_point(b)));
    const Vec3 direction = random_point(random, 1).normalized();

    double near = 0;
    double far = 4 * (size_of(a) + size_of(b));
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * near + 0.5 * far;
        const PosePair now{poses.a, moved(poses.b, middle * direction)};
        (may_overlap(a, b, now) ? near : far) = middle;
    }
    return {{poses.a, moved(poses.b, near * direction)},
            {poses.a, moved(poses.b, far * direction)},
            direction};
}

TEST(BoxTest, RejectsOnlyBoxesThatAreApart) {
    for (SeededRandom random : seeds(200)) {
        // Roundings of the centres matter most for small, distant boxes.
        const double offset = random.seed % 2 == 0 ? 1e6 : 1.0;
        const double scale = random.seed % 2 == 0 ? 1e-5 : 1.0;
        const ObbNode a = random_node(random, offset, scale);
        const ObbNode b = random_node(random, offset, scale);
        const PosedBrink brink = find_brink(random, a, b, offset);
        ASSERT_FALSE(may_overlap(a, b, brink.outside));
        ASSERT_FALSE(exactly_overlap(a, b, brink.outside));
    }
}

TEST(BoxTest, RejectsBoxesApartByAHundredThousandthOfTheirSize) {
    for (SeededRandom random : seeds(40)) {
        const ObbNode a = random_node(random, 1.0);
        const ObbNode b = random_node(random, 1.0);
        const PosedBrink brink = find_brink(random, a, b, 1.0);
        // Pulled back by at most the margin, the boxes really overlap.
        const double gap = 1e-5 * (size_of(a) + size_of(b));
        double pulled = 0;
        PosePair poses = brink.inside;
        while (!exactly_overlap(a, b, poses)) {
            pulled += 0.25 * gap;
            poses.b = moved(brink.inside.b, -pulled * brink.direction);
            // On a line that grazes the boxes the gap opens slowly.
            ASSERT_LT(pulled, 20 * gap);
        }
    }
}

TEST(BoxTest, KeepsBoxesThatTouchInOnePoint) {
    // Adjacent boxes of one body, on a lattice that floats represent exactly.
    ObbNode a;
    a.axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    a.half = {0.5F, 0.5F, 0.5F};
    for (const double x : {-1.0, 0.0, 1.0}) {
        for (const double y : {-1.0, 0.0, 1.0}) {
            for (const double z : {-1.0, 0.0, 1.0}) {
                EXPECT_TRUE(may_overlap(a, a, {Pose{}, translation_pose(x, y, z)}));
                EXPECT_FALSE(
                    may_overlap(a, a, {Pose{}, translation_pose(x * 1.01, y * 1.01, 1.01)}));
            }
        }
    }
}

TEST(BoxTest, BoxesAreAtLeastAsFarApartAsTheLeastDistance) {
    for (SeededRandom random : seeds(300)) {
        const ObbNode a = random_node(random, 1.0);
        const ObbNode b = random_node(random, 1.0);
        PosePair poses{make_pose(random, 1.0), make_pose(random, 1.0)};
        // Moves B so that a point of its surface coincides with a point of A.
        const auto point = [&](const ObbNode& box) {
            Vec3 at = center_point(box);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double share = std::clamp(uniform(random, -2, 2), -1.0, 1.0);
                for (std::size_t i = 0; i < 3; ++i) {
                    at[static_cast<Eigen::Index>(i)] += share *
                                                        static_cast<double>(box.half[axis]) *
                                                        static_cast<double>(box.axes[3 * axis + i]);
                }
            }
            return at;
        };
        poses.b = moved(poses.b, poses.a.apply(point(a)) - poses.b.apply(point(b)));
        EXPECT_EQ(least_distance(a, b, poses), 0);
        const double apart = uniform(random, 0, 100);
        poses.b = moved(poses.b, apart * random_point(random, 1).normalized());
        EXPECT_LE(least_distance(a, b, poses), apart);
    }
}

TEST(BoxTest, TheLeastDistanceIsThatOfFacesEdgesAndCornersThatFaceEachOther) {
    ObbNode a;
    a.axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    a.half = {0.5F, 0.5F, 0.5F};
    for (const Vec3& gap : {Vec3(3, 0, 0), Vec3(3, 0, 4), Vec3(2, -3, 6)}) {
        const Vec3 sign = gap.cwiseSign();
        const Vec3 apart = gap + sign;
        const PosePair poses{Pose{}, translation_pose(apart.x(), apart.y(), apart.z())};
        EXPECT_LE(least_distance(a, a, poses), gap.norm());
        EXPECT_GT(least_distance(a, a, poses), 0.985 * gap.norm());
    }
}

TEST(BoxTest, ParallelEdgesDoNotReject) {
    for (SeededRandom random : seeds(50)) {
        const ObbNode a = random_node(random, 1.0);
        const Pose pose = make_pose(random, 5.0);
        EXPECT_TRUE(may_overlap(a, a, {pose, pose}));
    }
}

TEST(BoxTest, OverflowMeansMaybe) {
    std::mt19937_64 random(1);
    ObbNode huge = random_node(random, 1.0);
    huge.half.fill(std::numeric_limits<float>::infinity());
    const ObbNode small = random_node(random, 1.0);
    const PosePair poses{make_pose(random, 10.0), make_matrix_pose(random, 10.0)};
    EXPECT_TRUE(may_overlap(huge, small, poses));
    EXPECT_EQ(least_distance(huge, small, poses), 0);
    EXPECT_TRUE(may_overlap(small, huge, poses));
    EXPECT_TRUE(may_overlap(huge, huge, poses));

    ObbNode far = small;
    far.center = {1.7e308, -1.7e308, 1.7e308};
    EXPECT_TRUE(may_overlap(small, far, poses));
    EXPECT_TRUE(may_overlap(far, far, poses));
}

TEST(BoxTest, AMatrixThatIsNoRotationMeansMaybe) {
    std::mt19937_64 random(2);
    const ObbNode a = random_node(random, 1.0);
    const Pose stretched = Pose::from_matrix(Mat3::Identity() * 3.0, Vec3(100, 0, 0));
    EXPECT_TRUE(may_overlap(a, a, {Pose{}, stretched}));
    EXPECT_TRUE(may_overlap(a, a, {stretched, Pose{}}));
    const Pose flat = Pose::from_matrix(Mat3::Zero(), Vec3(100, 0, 0));
    EXPECT_TRUE(may_overlap(a, a, {flat, Pose{}}));
}

} // namespace

} // namespace cd::tests
