// Proves that the bound on the distance of undecided boxes is true in the world.
#include "common/search/binary_search.hpp"

#include "tests/common/tree/exact_box.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cd::tests {

namespace {

/// Returns the least squared distance of two vertices of the meshes in the world.
Rational squared_vertex_distance(const Mesh& a, const Mesh& b, const PosePair& poses) {
    const auto world = [](const Mesh& mesh, const Pose& pose) {
        std::vector<ExactVec> places;
        for (const Vec3& vertex : mesh.vertices()) {
            places.push_back(exact_rotation(pose) * exact(vertex) + exact(pose.translation()));
        }
        return places;
    };
    const std::vector<ExactVec> of_b = world(b, poses.b);
    std::optional<Rational> least;
    for (const ExactVec& x : world(a, poses.a)) {
        for (const ExactVec& y : of_b) {
            const ExactVec between = x + scaled(Rational(-1), y);
            const Rational square = dot(between, between);
            least = least ? std::min(*least, square) : square;
        }
    }
    return *least;
}

TEST(BinarySearch, TheDistanceThatATolerancePromisesIsTrueInTheWorld) {
    std::size_t undecided = 0;
    std::size_t decided = 0;
    for (SeededRandom random : seeds(60)) {
        const double offset = random.seed % 2 == 0 ? 1.0 : 1e6;
        // Two small soups, whose boxes overlap or just do not, far from the poses' origins.
        const Vec3 place = random_point(random, offset);
        const ObbTree a = make_tree(translated(make_triangle_soup(random, 3), place));
        const ObbTree b = make_tree(translated(make_triangle_soup(random, 3), place));
        PosePair poses{any_pose(random, offset), any_pose(random, offset)};
        const Vec3 between = poses.a.apply(place) - poses.b.apply(place);
        poses.b =
            with_translation(poses.b, poses.b.translation() + between + random_point(random, 1.0));
        for (const double tolerance : {100.0, 4.0, 1.0}) {
            BinarySearch search(poses, {}, {.tolerance = tolerance});
            search.collect(a.view(), b.view());
            const auto distance = search.report().undecided_distance;
            if (!distance) {
                ++decided;
                continue;
            }
            ++undecided;
            ASSERT_TRUE(std::isfinite(*distance));
            ASSERT_LE(squared_vertex_distance(a.mesh(), b.mesh(), poses),
                      Rational(*distance) * Rational(*distance));
        }
    }
    EXPECT_GT(undecided, 40u);
    EXPECT_GT(decided, 10u);
}

TEST(BinarySearch, TheDistanceThatATolerancePromisesCountsHowPosesStretch) {
    // Two points with the smallest boxes: their distance is the bound, up to the boxes' margins.
    // A's pose lengthens vectors.
    const ObbTree point = make_tree(make_mesh({Vec3::Zero()}, {{0, 0, 0}}));
    const double stretch = 1 + 1e-4;
    const Pose longer = Pose::from_matrix(stretch * Mat3::Identity(), Vec3::Zero());
    for (const double apart : {1e-40, 1e-30, 1e-25}) {
        const PosePair poses{longer, translation_pose(apart, apart, apart)};
        BinarySearch search(poses, {}, {.tolerance = 1e-6});
        search.collect(point.view(), point.view());
        if (const auto distance = search.report().undecided_distance) {
            EXPECT_LE(squared_vertex_distance(point.mesh(), point.mesh(), poses),
                      Rational(*distance) * Rational(*distance));
        }
    }
    // Under poses that overflow, the bound is infinite, never NaN.
    const double big = 1.7e308;
    BinarySearch overflowing(
        {translation_pose(big, 0, 0), translation_pose(-big, 0, 0)}, {}, {.tolerance = 1e-6});
    overflowing.collect(point.view(), point.view());
    ASSERT_TRUE(overflowing.report().undecided_distance);
    EXPECT_EQ(*overflowing.report().undecided_distance, std::numeric_limits<double>::infinity());
}

} // namespace

} // namespace cd::tests
