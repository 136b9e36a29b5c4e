// Proves the confidence interval of a share against published values and by its own coverage.
#include "client/groups/wilson.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cd::tests {

TEST(Wilson, GivesPublishedIntervals) {
    // Newcombe, Two-sided confidence intervals for the single proportion (1998), table I, method 3.
    const ShareInterval rare = wilson_interval(15, 148);
    EXPECT_NEAR(rare.low, 0.0624, 5e-5);
    EXPECT_NEAR(rare.high, 0.1605, 5e-5);
    const ShareInterval none = wilson_interval(0, 20);
    EXPECT_EQ(none.low, 0);
    EXPECT_NEAR(none.high, 0.1611, 5e-5);
    const ShareInterval frequent = wilson_interval(81, 263);
    EXPECT_NEAR(frequent.low, 0.2553, 5e-5);
    EXPECT_NEAR(frequent.high, 0.3662, 5e-5);
}

TEST(Wilson, HoldsTheShareAndStaysWithinZeroAndOne) {
    for (std::uint64_t trials = 1; trials < 40; ++trials) {
        for (std::uint64_t hits = 0; hits <= trials; ++hits) {
            const ShareInterval interval = wilson_interval(hits, trials);
            const double share = static_cast<double>(hits) / static_cast<double>(trials);
            EXPECT_LE(0, interval.low);
            EXPECT_LE(interval.low, share);
            EXPECT_LE(share, interval.high);
            EXPECT_LE(interval.high, 1);
            const ShareInterval mirrored = wilson_interval(trials - hits, trials);
            EXPECT_NEAR(interval.low, 1 - mirrored.high, 1e-12);
        }
    }
}

TEST(Wilson, KnowsNothingWithoutTrials) {
    const ShareInterval interval = wilson_interval(0, 0);
    EXPECT_EQ(interval.low, 0);
    EXPECT_EQ(interval.high, 1);
}

} // namespace cd::tests
