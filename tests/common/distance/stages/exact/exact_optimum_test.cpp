// Proves that a feature is taken for the nearest exactly if its distance is the least, and that the
// nearest one is recognised.
#include "common/distance/stages/exact/exact_optimum.hpp"

#include "tests/support/distance_oracle.hpp"
#include "tests/support/distance_pairs.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

namespace {

ExactLattice lattice_of(const PosedPair& c) {
    return exact_lattice(to_exact(c.poses.a), c.a, to_exact(c.poses.b), c.b, Vec3::Zero());
}

bool is_equal(const ExactSquare& l, const ExactSquare& r) {
    return l.n * r.d == r.n * l.d;
}

} // namespace

TEST(ExactOptimum, RecognisesTheNearestFeatureAndNoOther) {
    int recognised = 0;
    int refused = 0;
    for (const auto& [name, make] : distance_pair_makers()) {
        SCOPED_TRACE(name);
        for (SeededRandom random : seeds(12)) {
            const PosedPair c = make(random);
            if (DistanceOracle(c.a, c.b, c.poses).share_a_point()) {
                continue;
            }
            const ExactLattice lattice = lattice_of(c);
            const ExactFeatures features(lattice.corners);
            const ExactSquare least = features.least();
            for (std::size_t number = 0; number < feature::count; ++number) {
                const auto square = features.square(number);
                const auto found = square_if_nearest(lattice.corners, number);
                if (square && is_equal(*square, least)) {
                    ASSERT_TRUE(found) << number;
                    ++recognised;
                }
                ASSERT_TRUE(!found || is_equal(*found, least)) << number;
                refused += found ? 0 : 1;
            }
        }
    }
    EXPECT_GT(recognised, 300);
    EXPECT_GT(refused, 1000);
}

} // namespace cd::tests
