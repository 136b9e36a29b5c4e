// Proves that pairs read from blocks are decided as pairs read from meshes, in either precision of
// each body: equal classes, true float verdicts (around their bounds too), and equal bits on every
// SIMD target and in any batch.
#include "tests/support/block_pairs.hpp"

#include "common/pair/stages/arbitrary/exact_triangle_pair.hpp"
#include "common/pair/stages/float/float_triangle_pair.hpp"
#include "common/pair/triangle_pair.hpp"
#include "tests/support/hard_pairs.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace cd::tests {

namespace {

/// Makes pairs of one kind; the common pose suits only the first.
std::vector<PosedPair> some_pairs(std::mt19937_64& random, const PairMaker& make) {
    std::vector<PosedPair> pairs;
    for (int i = 0; i < 40; ++i) {
        pairs.push_back(make(random));
    }
    return pairs;
}

/// Moves B by small steps, under one pose, through the distances at which floats become
/// certain.
std::vector<PosedPair> moved_through_bounds(std::mt19937_64& random) {
    const PosedPair start = nearly_touching(random);
    const Vec3 direction = random_point(random, 1);
    std::vector<PosedPair> pairs;
    for (int exponent = -30; exponent < -14; ++exponent) {
        pairs.push_back(start);
        const double step = std::ldexp(uniform(random, -2, 2), exponent);
        for (Vec3& corner : pairs.back().b) {
            corner += step * direction;
        }
    }
    return pairs;
}

/// Returns the verdicts on all candidates but the first.
std::vector<FloatVerdict>
verdicts_of(const BlockPairs& blocks, const FloatTrianglePair& test, std::size_t left_out) {
    const auto candidates = std::span(blocks.candidates).subspan(left_out);
    std::vector<FloatVerdict> verdicts(candidates.size());
    test.classify(blocks.a.view(), blocks.b.view(), candidates, verdicts);
    return verdicts;
}

struct Counts {
    std::size_t all = 0;
    std::size_t decided = 0;
    std::size_t wrong = 0;

    Counts& operator+=(const Counts& other) {
        all += other.all;
        decided += other.decided;
        wrong += other.wrong;
        return *this;
    }
};

Counts judge(const BlockPairs& blocks, const PosePair& poses, double bound_scale) {
    const auto verdicts = verdicts_of(blocks, FloatTrianglePair(poses, bound_scale), 0);
    const ExactTrianglePair exact(poses);
    Counts counts;
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
        ++counts.all;
        if (verdicts[i] != FloatVerdict::Unknown) {
            ++counts.decided;
            const PairClass claimed =
                verdicts[i] == FloatVerdict::Separate ? PairClass::Separate : PairClass::Proper;
            counts.wrong +=
                exact.classify(blocks.corners_a(i), blocks.corners_b(i)) == claimed ? 0u : 1u;
        }
    }
    return counts;
}

Counts search_around_bounds(std::uint64_t seed, const Kinds& kinds, double bound_scale) {
    std::mt19937_64 random(seed);
    Counts counts;
    for (int i = 0; i < 1500; ++i) {
        const auto pairs = moved_through_bounds(random);
        counts += judge(BlockPairs(random, kinds, pairs), pairs.front().poses, bound_scale);
    }
    return counts;
}

} // namespace

class BlockPairsTest : public testing::TestWithParam<Kinds> {};

INSTANTIATE_TEST_SUITE_P(Precisions,
                         BlockPairsTest,
                         testing::Values(Kinds{Precision::Float, Precision::Float},
                                         Kinds{Precision::Float, Precision::Double},
                                         Kinds{Precision::Double, Precision::Float},
                                         Kinds{Precision::Double, Precision::Double}),
                         [](const auto& one) {
                             return to_text(one.param.a) + to_text(one.param.b);
                         });

TEST_P(BlockPairsTest, ClassesAreThoseOfTheTrianglesAlone) {
    std::mt19937_64 random(21);
    for (const auto& [name, make] : pair_makers()) {
        SCOPED_TRACE(name);
        for (int round = 0; round < 10; ++round) {
            const auto pairs = some_pairs(random, make);
            const BlockPairs blocks(random, GetParam(), pairs);
            TrianglePairTest test(pairs.front().poses);
            const auto found = test.classify(blocks.a.view(), blocks.b.view(), blocks.candidates);
            const std::vector<PairClass> kinds(found.begin(), found.end());
            bool any = false;
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                ASSERT_EQ(kinds[i], test.classify(blocks.corners_a(i), blocks.corners_b(i)));
                any = any || kinds[i] != PairClass::Separate;
            }
            const auto touch = test.find_touch(blocks.a.view(), blocks.b.view(), blocks.candidates);
            ASSERT_EQ(touch.has_value(), any);
            EXPECT_TRUE(!touch || kinds[*touch] != PairClass::Separate);
        }
    }
}

TEST_P(BlockPairsTest, FloatVerdictsAreTrue) {
    std::mt19937_64 random(22);
    Counts counts;
    for (const auto& [name, make] : pair_makers()) {
        SCOPED_TRACE(name);
        for (int round = 0; round < 5; ++round) {
            const auto pairs = some_pairs(random, make);
            const BlockPairs blocks(random, GetParam(), pairs);
            counts += judge(blocks, pairs.front().poses, 1);
            ASSERT_EQ(counts.wrong, 0u);
        }
    }
    // Hard pairs are ordinary under another pair's pose.
    EXPECT_GT(counts.decided, counts.all / 4);
}

TEST_P(BlockPairsTest, FloatVerdictsAreTrueAroundTheirBounds) {
    const Counts counts = search_around_bounds(23, GetParam(), 1);
    EXPECT_EQ(counts.wrong, 0u);
    // The search crossed the bounds.
    EXPECT_GT(counts.decided, counts.all / 4);
    EXPECT_LT(counts.decided, counts.all * 3 / 4);
}

TEST_P(BlockPairsTest, BoundsScaledDownAreCaught) {
    EXPECT_GT(search_around_bounds(23, GetParam(), 0.03).wrong, 0u);
}

TEST_P(BlockPairsTest, EveryTargetGivesTheSameVerdicts) {
    std::mt19937_64 random(24);
    for (int round = 0; round < 300; ++round) {
        const auto pairs = moved_through_bounds(random);
        const BlockPairs blocks(random, GetParam(), pairs);
        const FloatTrianglePair test(pairs.front().poses);
        const std::vector<FloatVerdict> expected = verdicts_of(blocks, test, 0);
        on_every_target([&](SimdTarget) { ASSERT_EQ(verdicts_of(blocks, test, 0), expected); });
    }
}

TEST_P(BlockPairsTest, AVerdictDoesNotDependOnTheBatch) {
    std::mt19937_64 random(25);
    std::vector<PosedPair> pairs;
    for (int i = 0; i < 200; ++i) {
        pairs.push_back({random_corners(random, 1), random_corners(random, 1), {}});
    }
    const BlockPairs blocks(random, GetParam(), pairs);
    const FloatTrianglePair test({make_pose(random, 0.3), make_pose(random, 0.3)});
    on_every_target([&](SimdTarget) {
        const std::vector<FloatVerdict> expected = verdicts_of(blocks, test, 0);
        for (std::size_t left_out = 1; left_out <= pairs.size(); ++left_out) {
            const std::vector<FloatVerdict> verdicts = verdicts_of(blocks, test, left_out);
            EXPECT_TRUE(std::equal(verdicts.begin(),
                                   verdicts.end(),
                                   expected.begin() + static_cast<std::ptrdiff_t>(left_out),
                                   expected.end()));
        }
    });
}

} // namespace cd::tests
