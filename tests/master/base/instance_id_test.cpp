// Proves that each known process counts once, and an unknown one each time.
#include "master/base/instance_id.hpp"

#include "common/core/limits/master.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(Losses, AProcessCountsOnce) {
    Losses losses;
    EXPECT_TRUE(losses.none());
    for (const InstanceId process : {70u, 71u, 70u, 71u}) {
        losses.add(process);
    }
    EXPECT_EQ(losses.count(), 2u);
    losses.add(72);
    EXPECT_EQ(losses.count(), 3u);
    EXPECT_FALSE(losses.none());
}

TEST(Losses, RepeatedLossesOfOneProcessEventuallyFail) {
    Losses losses;
    for (std::size_t i = 0; i <= 2 * limits::losses_again_that_count; ++i) {
        EXPECT_LT(losses.count(), limits::scenario_losses_max);
        losses.add(70);
    }
    EXPECT_EQ(losses.count(), limits::scenario_losses_max);
}

TEST(Losses, AnUnknownProcessCountsEachTime) {
    Losses losses;
    for (std::size_t i = 1; i <= 2 * limits::scenario_losses_max; ++i) {
        losses.add(0);
        EXPECT_EQ(losses.count(), i);
    }
}

} // namespace
} // namespace cd::tests
