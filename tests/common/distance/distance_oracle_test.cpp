// Proves that the oracle's two ways to the squared distance agree, and that its roundings are those
// of known numbers.
#include "tests/support/distance_oracle.hpp"

#include "tests/support/distance_pairs.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cd::tests {

namespace {

ExactTriangle triangle_of(const std::vector<ExactPoint>& points) {
    return {points[0], points[1], points[2]};
}

} // namespace

TEST(DistanceOracle, FeaturesAgreeWithTheMinkowskiDifference) {
    int apart = 0;
    int sharing = 0;
    for (const auto& [name, make] : distance_pair_makers()) {
        SCOPED_TRACE(name);
        for (SeededRandom random : seeds(30)) {
            const PosedPair c = make(random);
            const ExactWorld world = exact_world(c.a, c.b, c.poses);
            const ExactTriangle a = triangle_of(world.a);
            const ExactTriangle b = triangle_of(world.b);
            const SquaredDistance square = squared_distance(a, b);
            ASSERT_EQ(square.compare(squared_norm_of_difference(a, b)), 0);
            ++(square.n == 0 ? sharing : apart);
        }
    }
    EXPECT_GT(apart, 500);
    EXPECT_GT(sharing, 50);
}

TEST(DistanceOracle, ATriangleThroughAnotherHasDistanceZeroWhereNoFeatureHas) {
    const DistanceOracle oracle({Vec3(-4, -4, 0), Vec3(4, -4, 0), Vec3(0, 4, 0)},
                                {Vec3(0, 0, -5), Vec3(0, 0, 5), Vec3(0.5, 0, 5)},
                                {});
    EXPECT_TRUE(oracle.share_a_point());
    EXPECT_TRUE(oracle.is_within(0));
    EXPECT_EQ(oracle.rounded(), 0);
}

TEST(DistanceOracle, RoundsRootsToTheNearestDouble) {
    constexpr double least = std::numeric_limits<double>::denorm_min();
    constexpr double most = std::numeric_limits<double>::max();
    const auto square = [](const mpq_class& x) { return mpq_class(x * x); };
    const mpq_class half_step(0x1p-53);
    EXPECT_EQ(oracle_nearest_root(square(mpq_class(1) + half_step)), 1); // A tie, to even.
    EXPECT_EQ(oracle_nearest_root(square(mpq_class(1) + 3 * half_step)), 1 + 0x1p-51);
    EXPECT_EQ(oracle_nearest_root(square(mpq_class(1) + half_step) + half_step * half_step),
              1 + 0x1p-52);
    EXPECT_EQ(oracle_nearest_root(square(mpq_class(least) / 2)), 0);
    EXPECT_EQ(oracle_nearest_root(square(mpq_class(least) * 3 / 2)), 2 * least);
    EXPECT_EQ(oracle_nearest_root(square(mpq_class(most) * 3)), most);
    EXPECT_EQ(oracle_nearest_root(mpq_class(2)), std::sqrt(2.0));
    EXPECT_EQ(oracle_nearest(mpq_class(-1) / 3), -1.0 / 3);
}

} // namespace cd::tests
