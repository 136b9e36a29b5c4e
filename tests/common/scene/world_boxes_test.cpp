// Proves that boxes computed many at a time are those computed one by one, bit for bit and on each
// SIMD target.

#include "common/scene/world_boxes.hpp"

#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cd::tests {

namespace {

struct PlacedBox {
    Aabb box;
    Pose pose;
    double margin = 0;
};

Aabb box_of_any_size(std::mt19937_64& random) {
    const double size = std::exp2(uniform(random, -40, 40));
    const Vec3 place = random_point(random, std::exp2(uniform(random, -40, 40)));
    Aabb box;
    box.add(place + random_point(random, size));
    box.add(place + random_point(random, size));
    return box;
}

/// Makes a matrix, a quaternion of a norm near 1, or one of any norm.
Pose pose_of_any_kind(std::mt19937_64& random) {
    const Vec3 place = random_point(random, std::exp2(uniform(random, -30, 140)));
    if (random() % 3 == 0) {
        Mat3 matrix;
        for (int i = 0; i < 3; ++i) {
            matrix.row(i) = random_point(random, 2).transpose();
        }
        return Pose::from_matrix(matrix, place);
    }
    const double norm = random() % 2 == 0 ? 1 : std::exp2(uniform(random, -300, 300));
    const auto share = [&] { return norm * uniform(random, -1, 1); };
    return Pose::from_quaternion({share(), share(), share(), share()}, place);
}

PlacedBox random_placed_box(std::mt19937_64& random) {
    return {box_of_any_size(random),
            pose_of_any_kind(random),
            random() % 2 == 0 ? 0 : std::exp2(uniform(random, -20, 20))};
}

std::vector<WorldBox> one_by_one(std::span<const PlacedBox> bodies) {
    std::vector<WorldBox> boxes;
    for (const PlacedBox& body : bodies) {
        boxes.push_back(world_box(body.box, body.pose, body.margin));
    }
    return boxes;
}

std::vector<WorldBox> many_at_a_time(std::span<const PlacedBox> bodies) {
    WorldBoxes boxes(bodies.size());
    for (const PlacedBox& body : bodies) {
        boxes.add(body.box, body.pose, body.margin);
    }
    return boxes.take();
}

} // namespace

TEST(WorldBoxes, AreThoseOfWorldBox) {
    std::size_t infinite = 0;
    on_every_target([&](SimdTarget) {
        for (SeededRandom random : seeds(raised(100))) {
            std::vector<PlacedBox> bodies(random() % 140);
            for (PlacedBox& body : bodies) {
                body = random_placed_box(random);
            }
            const std::vector<WorldBox> boxes = many_at_a_time(bodies);
            EXPECT_EQ(boxes, one_by_one(bodies));
            for (const WorldBox& box : boxes) {
                infinite += std::isinf(box.high[0]) ? 1 : 0;
            }
        }
    });
    EXPECT_GT(infinite, 0u);
}

TEST(WorldBoxes, AreThoseOfWorldBoxWhereNumbersAreTheLargestOrTheLeast) {
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr double least = std::numeric_limits<double>::denorm_min();
    constexpr double float_least = std::numeric_limits<float>::denorm_min();
    const std::vector<double> numbers{0,
                                      -0.0,
                                      least,
                                      -least,
                                      float_least,
                                      -float_least,
                                      1,
                                      0x1.fffffep127,
                                      0x1.ffffffp127,
                                      -largest,
                                      largest};
    std::vector<PlacedBox> bodies;
    for (const double place : numbers) {
        for (const double end : numbers) {
            Aabb box;
            box.add(Vec3::Constant(end));
            box.add(Vec3(0, end, 0));
            bodies.push_back({box, Pose::from_quaternion({}, Vec3(place, 0, -place)), 0});
            bodies.push_back(
                {box, Pose::from_matrix(Mat3::Constant(end), Vec3::Constant(place)), 0});
        }
    }
    on_every_target([&](SimdTarget) { EXPECT_EQ(many_at_a_time(bodies), one_by_one(bodies)); });
}

} // namespace cd::tests
