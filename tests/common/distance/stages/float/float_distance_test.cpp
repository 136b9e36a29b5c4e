// Proves that what floats prove about distances is true, also around their error bounds, from
// blocks of either precision and on every SIMD target, and that the error bounds are needed.
#include "common/distance/stages/float/float_distance.hpp"

#include "tests/support/block_pairs.hpp"
#include "tests/support/distance_oracle.hpp"
#include "tests/support/distance_pairs.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cd::tests {

namespace {

/// Pairs under the first one's poses, and the exact distance of each.
struct Posed {
    BlockPairs blocks;
    PosePair poses;
    std::vector<DistanceOracle> exact;

    Posed(std::mt19937_64& random, const Kinds& kinds, const std::vector<PosedPair>& pairs)
        : blocks(random, kinds, pairs), poses(pairs.front().poses) {
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            exact.emplace_back(blocks.corners_a(i), blocks.corners_b(i), poses);
        }
    }
};

std::vector<PosedPair> made(std::mt19937_64& random, const PairMaker& make, int count) {
    std::vector<PosedPair> pairs;
    for (int i = 0; i < count; ++i) {
        pairs.push_back(make(random));
    }
    return pairs;
}

struct FloatCounts {
    std::size_t all = 0;
    std::size_t decided = 0;
    std::size_t wrong = 0;
};

std::vector<NearVerdict> verdicts_of(const Posed& pairs, const FloatDistance& test, double d) {
    std::vector<NearVerdict> verdicts(pairs.exact.size());
    test.decide(pairs.blocks.a.view(), pairs.blocks.b.view(), pairs.blocks.candidates, d, verdicts);
    return verdicts;
}

void judge_verdicts(const Posed& pairs, const FloatDistance& test, double d, FloatCounts& counts) {
    const std::vector<NearVerdict> verdicts = verdicts_of(pairs, test, d);
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
        ++counts.all;
        if (verdicts[i] != NearVerdict::Unknown) {
            ++counts.decided;
            const bool is_near = verdicts[i] == NearVerdict::Near;
            counts.wrong += pairs.exact[i].is_within(d) == is_near ? 0u : 1u;
        }
    }
}

/// Compares distances with numbers that are nearer and nearer to them.
FloatCounts judged_around_bounds(const Kinds& kinds, double error_scale) {
    std::mt19937_64 random(31);
    FloatCounts counts;
    const auto make = [](std::mt19937_64& r) {
        return PosedPair{
            random_corners(r, 1), random_corners(r, 1), {make_pose(r, 1), make_pose(r, 1)}};
    };
    for (int round = 0; round < 12; ++round) {
        const Posed pairs(random, kinds, made(random, make, 16));
        const FloatDistance test(pairs.poses, error_scale);
        for (const DistanceOracle& exact : pairs.exact) {
            for (int exponent = -30; exponent < -14; ++exponent) {
                const double off = std::ldexp(uniform(random, -1, 1), exponent);
                const double d = exact.rounded() * (1 + off);
                judge_verdicts(pairs, test, d, counts);
            }
        }
    }
    return counts;
}

} // namespace

class FloatDistanceTest : public testing::TestWithParam<Kinds> {};

TEST_P(FloatDistanceTest, VerdictsAreTrueOnHardPairs) {
    std::mt19937_64 random(32);
    FloatCounts counts;
    for (const auto& [name, make] : distance_pair_makers()) {
        SCOPED_TRACE(name);
        const Posed pairs(random, GetParam(), made(random, make, 20));
        const FloatDistance test(pairs.poses);
        for (const double d : bounds_around(random, pairs.exact.front().rounded())) {
            judge_verdicts(pairs, test, d, counts);
        }
        ASSERT_EQ(counts.wrong, 0u);
    }
    EXPECT_GT(counts.decided, counts.all / 4);
}

TEST_P(FloatDistanceTest, VerdictsAreTrueAroundTheirBounds) {
    const FloatCounts counts = judged_around_bounds(GetParam(), 1);
    EXPECT_EQ(counts.wrong, 0u);
    EXPECT_GT(counts.decided, counts.all / 4);
    EXPECT_LT(counts.decided, counts.all);
}

TEST_P(FloatDistanceTest, BoundsThatAreScaledDownAreCaught) {
    EXPECT_GT(judged_around_bounds(GetParam(), 0.003).wrong, 0u);
}

TEST_P(FloatDistanceTest, DistancesAreWithinTheirBoundsOnEveryTarget) {
    std::mt19937_64 random(33);
    std::size_t close = 0;
    for (const auto& [name, make] : distance_pair_makers()) {
        SCOPED_TRACE(name);
        const Posed pairs(random, GetParam(), made(random, make, 20));
        const FloatDistance test(pairs.poses);
        on_every_target([&](SimdTarget) {
            std::vector<float> lower(pairs.exact.size());
            std::vector<float> upper(pairs.exact.size());
            test.bound(pairs.blocks.a.view(),
                       pairs.blocks.b.view(),
                       pairs.blocks.candidates,
                       lower,
                       upper);
            for (std::size_t i = 0; i < lower.size(); ++i) {
                const auto low = double{lower[i]};
                ASSERT_TRUE(pairs.exact[i].square() >= mpq_class(low) * mpq_class(low));
                ASSERT_TRUE(std::isinf(upper[i]) || pairs.exact[i].is_within(double{upper[i]}));
                close += lower[i] > 0 && upper[i] < 1.001F * lower[i] ? 1 : 0;
            }
        });
    }
    EXPECT_GT(close, 100u);
}

TEST_P(FloatDistanceTest, EveryTargetGivesTheSameVerdicts) {
    std::mt19937_64 random(34);
    for (const auto& [name, make] : distance_pair_makers()) {
        SCOPED_TRACE(name);
        const Posed pairs(random, GetParam(), made(random, make, 37));
        const FloatDistance test(pairs.poses);
        const double d = pairs.exact.back().rounded();
        const std::vector<NearVerdict> expected = verdicts_of(pairs, test, d);
        on_every_target([&](SimdTarget) { ASSERT_EQ(verdicts_of(pairs, test, d), expected); });
    }
}

INSTANTIATE_TEST_SUITE_P(Precisions,
                         FloatDistanceTest,
                         testing::Values(Kinds{Precision::Float, Precision::Float},
                                         Kinds{Precision::Float, Precision::Double},
                                         Kinds{Precision::Double, Precision::Float},
                                         Kinds{Precision::Double, Precision::Double}),
                         [](const auto& of) {
                             return to_text(of.param.a) + "And" + to_text(of.param.b);
                         });

} // namespace cd::tests
