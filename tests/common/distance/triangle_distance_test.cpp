// Proves that distances of pairs are decided exactly, whatever the first stage: on random and on
// hard pairs all answers equal those of rationals. CD_ROUNDS multiplies the rounds of a kind.
#include "common/distance/triangle_distance.hpp"

#include "tests/common/pair/pair_batch.hpp"
#include "tests/support/distance_oracle.hpp"
#include "tests/support/distance_pairs.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

constexpr std::array all_stages{
    DistanceStage::Float, DistanceStage::Double, DistanceStage::DoubleDouble, DistanceStage::Exact};

PosedPair swapped(const PosedPair& c) {
    return {c.b, c.a, {c.poses.b, c.poses.a}};
}

void expect_equal(const NearestPoints& found, const NearestPoints& expected) {
    ASSERT_EQ(found.feature, expected.feature);
    ASSERT_EQ(found.origin, expected.origin);
    ASSERT_EQ(found.of_a, expected.of_a);
    ASSERT_EQ(found.of_b, expected.of_b);
}

/// What the oracle says about a pair, and the bounds to compare the distance with.
struct Truth {
    double rounded = 0;
    NearestPoints nearest;
    std::vector<double> bounds;
    std::vector<bool> within;

    Truth(std::mt19937_64& random, const DistanceOracle& oracle)
        : rounded(oracle.rounded()),
          nearest(oracle.nearest()),
          bounds(bounds_around(random, rounded)) {
        for (const double d : bounds) {
            within.push_back(oracle.is_within(d));
        }
    }
};

void expect_truth(const PosedPair& c, DistanceStage first, const Truth& truth) {
    SCOPED_TRACE(to_text(first));
    TriangleDistance distance(c.poses, first);
    for (std::size_t i = 0; i < truth.bounds.size(); ++i) {
        ASSERT_EQ(distance.is_within(c.a, c.b, truth.bounds[i]), truth.within[i])
            << truth.bounds[i];
    }
    ASSERT_EQ(distance.rounded(c.a, c.b), truth.rounded);
    expect_equal(distance.nearest(c.a, c.b), truth.nearest);
}

} // namespace

class TriangleDistanceTest : public testing::TestWithParam<std::string> {};

TEST_P(TriangleDistanceTest, AllAnswersAreExactWhateverTheFirstStage) {
    const PairMaker make = distance_pair_makers().at(GetParam());
    int apart = 0;
    int comparisons = 0; // Of a pair's distance with a number.
    for (SeededRandom random : seeds(raised(310))) {
        const PosedPair c = make(random);
        const DistanceOracle oracle(c.a, c.b, c.poses);
        if (oracle.share_a_point()) {
            continue;
        }
        ++apart;
        const Truth truth(random, oracle);
        comparisons += static_cast<int>(truth.bounds.size());
        for (const DistanceStage first : all_stages) {
            expect_truth(c, first, truth);
        }
        const PosedPair other = swapped(c);
        ASSERT_EQ(TriangleDistance(other.poses).rounded(other.a, other.b), truth.rounded);
        if (HasFatalFailure()) {
            return;
        }
    }
    RecordProperty("pairs_apart", apart);
    RecordProperty("comparisons", comparisons);
    EXPECT_GT(apart, 40);
}

/// The pairs of a kind, under the poses of the first one, that share no point.
struct SpanPairs {
    PosePair poses;
    Batch batch;
    std::vector<DistanceOracle> exact;

    SpanPairs(std::mt19937_64& random, const PairMaker& make) {
        for (int i = 0; i < 60; ++i) {
            const PosedPair c = make(random);
            poses = i == 0 ? c.poses : poses;
            DistanceOracle oracle(c.a, c.b, poses);
            if (!oracle.share_a_point()) {
                batch.add(c.a, c.b);
                exact.push_back(std::move(oracle));
            }
        }
    }
};

void expect_true_batch(const SpanPairs& pairs, TriangleDistance& distance, double d) {
    const auto a = pairs.batch.a();
    const auto b = pairs.batch.b();
    const auto answers = distance.within(a, b, pairs.batch.candidates, d);
    ASSERT_EQ(answers.size(), pairs.exact.size());
    bool any = false;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        ASSERT_EQ(answers[i] != 0, pairs.exact[i].is_within(d)) << i;
        any = any || answers[i] != 0;
    }
    const auto found = distance.find_within(a, b, pairs.batch.candidates, d);
    ASSERT_EQ(found.has_value(), any);
    ASSERT_TRUE(!found || pairs.exact[*found].is_within(d));
}

TEST_P(TriangleDistanceTest, BatchesAreExactOnEveryTarget) {
    std::size_t comparisons = 0;
    for (SeededRandom random : seeds(raised(1))) {
        const SpanPairs pairs(random, distance_pair_makers().at(GetParam()));
        for (std::size_t i = 0; i < pairs.exact.size(); i += 13) {
            for (const double d : bounds_around(random, pairs.exact[i].rounded())) {
                comparisons += pairs.exact.size();
                TriangleDistance exactly(pairs.poses, DistanceStage::Exact);
                expect_true_batch(pairs, exactly, d);
                on_every_target([&](SimdTarget) {
                    TriangleDistance distance(pairs.poses);
                    expect_true_batch(pairs, distance, d);
                });
            }
        }
    }
    RecordProperty("comparisons", static_cast<int>(comparisons));
}

TEST(TriangleDistance, RestartForgetsThePoses) {
    std::mt19937_64 random(8);
    TriangleDistance reused({});
    for (int i = 0; i < 50; ++i) {
        const PosedPair c{random_corners(random, 1),
                          random_corners(random, 1),
                          {make_pose(random, 5), make_matrix_pose(random, 5)}};
        if (DistanceOracle(c.a, c.b, c.poses).share_a_point()) {
            continue;
        }
        reused.restart(c.poses);
        EXPECT_EQ(reused.statistics().total(), 0u);
        const double rounded = reused.rounded(c.a, c.b);
        EXPECT_EQ(rounded, TriangleDistance(c.poses, DistanceStage::Exact).rounded(c.a, c.b));
        EXPECT_TRUE(reused.is_within(c.a, c.b, rounded * (1 + 1e-15)));
        EXPECT_FALSE(reused.is_within(c.a, c.b, rounded * (1 - 1e-15)));
    }
}

TEST(TriangleDistance, CheapStagesDecideOrdinaryPairs) {
    std::mt19937_64 random(9);
    const SpanPairs pairs(random, distance_pair_makers().at("apart under two quaternions"));
    TriangleDistance distance(pairs.poses);
    const auto all = pairs.exact.size();
    static_cast<void>(distance.within(pairs.batch.a(), pairs.batch.b(), pairs.batch.candidates, 1));
    EXPECT_EQ(distance.statistics()[DistanceStage::Float], all);
    for (std::size_t i = 0; i < all; ++i) {
        static_cast<void>(
            distance.rounded(pairs.batch.a().corners_at(pairs.batch.candidates[i].a),
                             pairs.batch.b().corners_at(pairs.batch.candidates[i].b)));
    }
    EXPECT_EQ(distance.statistics()[DistanceStage::DoubleDouble], all);
}

INSTANTIATE_TEST_SUITE_P(,
                         TriangleDistanceTest,
                         testing::ValuesIn([] {
                             std::vector<std::string> names;
                             for (const auto& [name, make] : distance_pair_makers()) {
                                 names.push_back(name);
                             }
                             return names;
                         }()),
                         [](const auto& of) {
                             std::string name = of.param;
                             std::replace_if(
                                 name.begin(),
                                 name.end(),
                                 [](char c) { return std::isalnum(c) == 0; },
                                 '_');
                             return name;
                         });

} // namespace cd::tests
