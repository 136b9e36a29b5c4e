// Proves that world boxes contain posed bodies, against rational numbers, and fit them closely.

#include "common/scene/world_box.hpp"

#include "tests/support/posed_point.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cd::tests {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Whether the box contains a point of rationals.
bool contains(const WorldBox& box, const std::array<mpq_class, 3>& point) {
    for (std::size_t i = 0; i < 3; ++i) {
        const bool above = std::isinf(box.low[i]) || mpq_class(box.low[i]) <= point[i];
        const bool below = std::isinf(box.high[i]) || point[i] <= mpq_class(box.high[i]);
        if (!above || !below) {
            return false;
        }
    }
    return true;
}

std::array<Vec3, 8> corners_of(const Aabb& box) {
    std::array<Vec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
        corners[i] = {(i & 1) != 0 ? box.max.x() : box.min.x(),
                      (i & 2) != 0 ? box.max.y() : box.min.y(),
                      (i & 4) != 0 ? box.max.z() : box.min.z()};
    }
    return corners;
}

Aabb random_box(std::mt19937_64& random) {
    const double size = std::exp2(uniform(random, -20, 20));
    const Vec3 place = random_point(random, std::exp2(uniform(random, -20, 20)));
    Aabb box;
    box.add(place + random_point(random, size));
    box.add(place + random_point(random, size));
    return box;
}

Quaternion random_turn(std::mt19937_64& random) {
    const double norm = std::exp2(uniform(random, -10, 10));
    return {norm * uniform(random, -1, 1),
            norm * uniform(random, -1, 1),
            norm * uniform(random, -1, 1),
            norm * uniform(random, -1, 1)};
}

Pose random_pose(std::mt19937_64& random) {
    const Vec3 place = random_point(random, std::exp2(uniform(random, -20, 30)));
    if (random() % 2 == 0) {
        return Pose::from_quaternion(random_turn(random), place);
    }
    Mat3 matrix;
    for (int i = 0; i < 3; ++i) {
        matrix.row(i) = random_point(random, 2).transpose();
    }
    return Pose::from_matrix(matrix, place);
}

/// Makes a pose that puts a corner of the box, as doubles compute it, at floats.
Pose pose_on_floats(std::mt19937_64& random, const Aabb& box) {
    const Quaternion turn = random_turn(random);
    const Vec3 corner =
        Pose::from_quaternion(turn, Vec3::Zero()).apply(corners_of(box)[random() % 8]);
    const Vec3 place = random_point(random, 1000).cast<float>().cast<double>();
    return Pose::from_quaternion(turn, place - corner);
}

int boxes_that_miss_a_corner(double error_scale) {
    int misses = 0;
    for (SeededRandom random : seeds(raised(300))) {
        const Aabb body = random_box(random);
        const Pose pose = pose_on_floats(random, body);
        const WorldBox box = world_box(body, pose, 0, error_scale);
        for (const Vec3& corner : corners_of(body)) {
            misses += contains(box, world_point<mpq_class>(pose, corner)) ? 0 : 1;
        }
    }
    return misses;
}

} // namespace

TEST(WorldBox, ContainsThePosedBody) {
    for (SeededRandom random : seeds(raised(500))) {
        const Aabb body = random_box(random);
        const Pose pose = random_pose(random);
        const WorldBox box = world_box(body, pose);
        for (const Vec3& corner : corners_of(body)) {
            EXPECT_TRUE(contains(box, world_point<mpq_class>(pose, corner)));
        }
    }
}

TEST(WorldBox, ContainsCornersAtItsFacesAndNeedsItsBoundsForThat) {
    EXPECT_EQ(boxes_that_miss_a_corner(1), 0);
    EXPECT_GT(boxes_that_miss_a_corner(0), 0);
}

TEST(WorldBox, OfACubeThatIsNotTurnedIsTheCube) {
    Aabb cube;
    cube.add(Vec3(-1, 2, 3));
    cube.add(Vec3(1, 4, 5));
    const WorldBox box = world_box(cube, Pose::from_quaternion({}, Vec3(10, 20, 30)));
    for (std::size_t i = 0; i < 3; ++i) {
        const float low = std::array{9.0f, 22.0f, 33.0f}.at(i);
        EXPECT_LE(box.low[i], low);
        EXPECT_GE(box.low[i], std::nextafter(low, -infinity));
        EXPECT_GE(box.high[i], low + 2);
        EXPECT_LE(box.high[i], std::nextafter(low + 2, infinity));
    }
}

TEST(WorldBox, GrowsByTheMargin) {
    for (SeededRandom random : seeds(200)) {
        const Aabb body = random_box(random);
        const Pose pose = random_pose(random);
        const double margin = std::exp2(uniform(random, -10, 10));
        const WorldBox box = world_box(body, pose, margin);
        for (const Vec3& corner : corners_of(body)) {
            for (int i = 0; i < 3; ++i) {
                for (const double side : {-1.0, 1.0}) {
                    auto point = world_point<mpq_class>(pose, corner);
                    point.at(static_cast<std::size_t>(i)) += side * mpq_class(margin);
                    EXPECT_TRUE(contains(box, point));
                }
            }
        }
    }
}

TEST(WorldBox, IsInfiniteWhereNumbersOverflow) {
    Aabb body;
    body.add(Vec3::Constant(-1));
    body.add(Vec3::Constant(1));
    const WorldBox far = world_box(body, Pose::from_quaternion({}, Vec3(1e300, 0, -1e300)));
    EXPECT_EQ(far.high[0], infinity);
    EXPECT_EQ(far.low[0], std::numeric_limits<float>::max());
    EXPECT_EQ(far.low[2], -infinity);
    Mat3 huge = Mat3::Identity();
    huge(1, 1) = 1e308;
    huge(1, 2) = 1e308;
    const WorldBox wide = world_box(body, Pose::from_matrix(huge, Vec3(0, 1e308, 0)));
    EXPECT_EQ(wide.low[1], -infinity);
    EXPECT_EQ(wide.high[1], infinity);
}

} // namespace cd::tests
