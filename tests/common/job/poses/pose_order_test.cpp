// Proves that the order of poses is a permutation that depends on them alone and brings nearby
// poses together.

#include "common/job/poses/pose_order.hpp"

#include "common/job/packed_scenarios.hpp"
#include "tests/support/scenarios.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

namespace cd::tests {

namespace {

Scenario at(std::uint64_t index, const Pose& b) {
    return make_scenario({Pose{}, b}, index);
}

/// Makes a cube of translations, shuffled.
std::vector<Scenario> grid(std::mt19937_64& random, int side) {
    std::vector<Scenario> scenarios;
    for (int x = 0; x < side; ++x) {
        for (int y = 0; y < side; ++y) {
            for (int z = 0; z < side; ++z) {
                scenarios.push_back(at(0, translation_pose(x, 10.0 * y, 0.1 * z)));
            }
        }
    }
    std::shuffle(scenarios.begin(), scenarios.end(), random);
    return scenarios;
}

/// Returns the mean number of grid steps from one scenario to the next.
double mean_step(const std::vector<Scenario>& scenarios, const std::vector<std::uint32_t>& order) {
    double sum = 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
        const Vec3 step = scenarios[order[i]].poses.b.translation() -
                          scenarios[order[i - 1]].poses.b.translation();
        sum += std::abs(step.x()) + std::abs(step.y()) / 10 + std::abs(step.z()) * 10;
    }
    return sum / static_cast<double>(order.size() - 1);
}

} // namespace

TEST(CoherentOrder, IsAPermutation) {
    std::mt19937_64 random(1);
    for (const int side : {1, 2, 5}) {
        const std::vector<Scenario> scenarios = grid(random, side);
        std::vector<std::uint32_t> order = coherent_order(scenarios);
        std::sort(order.begin(), order.end());
        std::vector<std::uint32_t> all(scenarios.size());
        std::iota(all.begin(), all.end(), 0u);
        EXPECT_EQ(order, all);
    }
    EXPECT_TRUE(coherent_order({}).empty());
}

TEST(CoherentOrder, BringsNeighboursTogether) {
    std::mt19937_64 random(2);
    const std::vector<Scenario> scenarios = grid(random, 8);
    std::vector<std::uint32_t> given(scenarios.size());
    std::iota(given.begin(), given.end(), 0u);
    EXPECT_GT(mean_step(scenarios, given), 7.0); // A shuffle has 3 * (8 - 1/8) / 3.
    EXPECT_LT(mean_step(scenarios, coherent_order(scenarios)), 2.0);
}

TEST(CoherentOrder, TellsRotationsApart) {
    std::vector<Scenario> scenarios;
    for (int i = 0; i < 64; ++i) {
        const Quaternion about_z{1, 0, 0, 0.01 * ((i * 37) % 64)};
        scenarios.push_back(
            at(static_cast<std::uint64_t>(i), Pose::from_quaternion(about_z, Vec3::Zero())));
    }
    const std::vector<std::uint32_t> order = coherent_order(scenarios);
    for (std::size_t i = 1; i < order.size(); ++i) {
        EXPECT_LT((order[i - 1] * 37) % 64, (order[i] * 37) % 64);
    }
}

TEST(CoherentOrder, KeepsTheOrderOfEqualPoses) {
    const std::vector<Scenario> scenarios(100, at(3, translation_pose(1, 2, 3)));
    std::vector<std::uint32_t> all(scenarios.size());
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(coherent_order(scenarios), all);
}

TEST(PackInOrder, TheTreesOfTheBodiesComeBeforeTheCurve) {
    std::mt19937_64 random(4);
    std::vector<Scenario> scenarios = grid(random, 4);
    for (std::uint64_t i = 0; i < scenarios.size(); ++i) {
        scenarios[i].index = i;
        scenarios[i].body_a = static_cast<std::uint32_t>(random() % 2);
        scenarios[i].body_b = 2 + static_cast<std::uint32_t>(random() % 2);
    }
    const std::vector<std::uint32_t> trees{0, 1, 2, 1}; // Bodies 1 and 3 have one mesh.
    const std::vector<Bytes> runs = pack_in_order(scenarios, trees);
    ASSERT_EQ(runs.size(), 1u);
    const auto packed = unpack_scenarios(runs[0], scenarios.size()).value();
    std::vector<Scenario> expected;
    for (const auto& [a, b] :
         {std::pair(0, 3), std::pair(0, 2), std::pair(1, 3), std::pair(1, 2)}) {
        std::vector<Scenario> of_pair;
        for (const Scenario& scenario : scenarios) {
            if (scenario.body_a == static_cast<std::uint32_t>(a) &&
                scenario.body_b == static_cast<std::uint32_t>(b)) {
                of_pair.push_back(scenario);
            }
        }
        ASSERT_FALSE(of_pair.empty());
        for (const std::uint32_t next : coherent_order(of_pair)) {
            expected.push_back(of_pair[next]);
        }
    }
    EXPECT_EQ(packed, expected);
}

} // namespace cd::tests
