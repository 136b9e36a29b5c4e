// Proves that distances of pairs are decided exactly, whatever the first stage: on random and on
// hard pairs all answers equal those of rationals. The number of rounds of a kind can be raised by
// the environment variable CD_ROUNDS.
#include "common/distance/triangle_distance.hpp"

#include "tests/support/distance_oracle.hpp"
#include "tests/support/distance_pairs.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

constexpr std::array all_stages{
    DistanceStage::Float, DistanceStage::Double, DistanceStage::DoubleDouble, DistanceStage::Exact};

std::uint64_t rounds_of_a_kind(std::uint64_t usual) {
    const char* const given = std::getenv("CD_ROUNDS");
    return given == nullptr ? usual : std::stoull(given);
}

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
    for (SeededRandom random : seeds(rounds_of_a_kind(40))) {
        const PosedPair c = make(random);
        const DistanceOracle oracle(c.a, c.b, c.poses);
        if (oracle.share_a_point()) {
            continue;
        }
        ++apart;
        const Truth truth(random, oracle);
        for (const DistanceStage first : all_stages) {
            expect_truth(c, first, truth);
        }
        const PosedPair other = swapped(c);
        ASSERT_EQ(TriangleDistance(other.poses).rounded(other.a, other.b), truth.rounded);
        if (HasFatalFailure()) {
            return;
        }
    }
    EXPECT_GT(apart, 5);
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
