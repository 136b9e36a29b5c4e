// Proves that the error bounds of distances in doubles and double-doubles are sufficient and
// needed: the exact distance is always within them, and is not if they are scaled down.
#include "common/distance/distance_certificate.hpp"

#include "common/distance/stages/double/double_distance.hpp"
#include "common/distance/stages/double_double/double_double_distance.hpp"
#include "tests/support/distance_oracle.hpp"
#include "tests/support/distance_pairs.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

namespace {

mpq_class exact_of(double value) {
    return mpq_class(value);
}
mpq_class exact_of(const DoubleDouble& value) {
    return mpq_class(value.high) + mpq_class(value.low);
}

/// Number of bounds that are wrong, and of those that are within a millionth of the distance.
struct Judged {
    int wrong = 0;
    int useful = 0;
};

template <class Number>
void judge(const DistanceBounds<Number>& bounds, const mpq_class& square, Judged& judged) {
    if (!bounds.are_proven) {
        return;
    }
    const mpq_class lower = exact_of(bounds.lower) - mpq_class(bounds.error);
    const mpq_class upper = exact_of(bounds.upper) + mpq_class(bounds.error);
    const bool is_wrong = (lower > 0 && lower * lower > square) || upper * upper < square;
    judged.wrong += is_wrong ? 1 : 0;
    judged.useful += lower > 0 && upper < lower * mpq_class(1.000001) ? 1 : 0;
}

/// Judges the bounds of `bounds_of(pair)` on hard pairs.
template <class BoundsOf>
Judged judged_pairs(std::uint64_t rounds, const BoundsOf& bounds_of) {
    Judged judged;
    for (const auto& [name, make] : distance_pair_makers()) {
        for (SeededRandom random : seeds(rounds)) {
            const PosedPair c = make(random);
            const DistanceOracle oracle(c.a, c.b, c.poses);
            if (!oracle.share_a_point()) {
                judge(bounds_of(c), oracle.square(), judged);
            }
        }
    }
    return judged;
}

Judged judged_in_doubles(double error_scale, std::uint64_t rounds) {
    return judged_pairs(rounds, [&](const PosedPair& c) {
        return DoubleDistance(c.poses, error_scale).look_at(c.a, c.b).bounds;
    });
}

Judged judged_in_double_doubles(double error_scale, std::uint64_t rounds) {
    return judged_pairs(rounds, [&](const PosedPair& c) {
        const DoublePair pair = DoubleDistance(c.poses).choose(c.a, c.b);
        return DoubleDoubleDistance(c.poses, error_scale)
            .bounds(c.a, c.b, pair.near_a, pair.feature);
    });
}

} // namespace

TEST(DistanceCertificate, BoundsInDoublesHoldAndAreClose) {
    const Judged judged = judged_in_doubles(1, 40);
    EXPECT_EQ(judged.wrong, 0);
    EXPECT_GT(judged.useful, 400);
}

TEST(DistanceCertificate, BoundsInDoubleDoublesHoldAndAreClose) {
    const Judged judged = judged_in_double_doubles(1, 40);
    EXPECT_EQ(judged.wrong, 0);
    EXPECT_GT(judged.useful, 700);
}

TEST(DistanceCertificate, BoundsThatAreScaledDownAreCaught) {
    EXPECT_GT(judged_in_doubles(0.03, 40).wrong, 0);
    EXPECT_GT(judged_in_double_doubles(0x1p-14, 40).wrong, 0);
}

TEST(DistanceCertificate, AnyFeatureMayBeProposed) {
    std::size_t number = 0;
    const Judged judged = judged_pairs(4, [&](const PosedPair& c) {
        const DoublePair pair = DoubleDistance(c.poses).choose(c.a, c.b);
        number = (number + 1) % feature::count;
        return DoubleDoubleDistance(c.poses).bounds(c.a, c.b, pair.near_a, number);
    });
    EXPECT_EQ(judged.wrong, 0);
}

} // namespace cd::tests
