// Proves that a transfer is measured from the request to the arrival, and no moment counts twice.
#include "master/blocks/transfer_meter.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cd::tests {
namespace {

constexpr TreeId tree{3};

std::optional<TransferMeter::Measured>
held(TransferMeter& meter, const std::vector<RootIndex>& roots, double now) {
    return meter.held(tree, roots, now);
}

TEST(TransferMeter, CountsFromTheAsking) {
    TransferMeter meter;
    meter.wanted(tree, 1, 1000, 2.0);
    meter.wanted(tree, 2, 500, 2.0);
    const auto measured = held(meter, {1, 2}, 2.5);
    ASSERT_TRUE(measured);
    EXPECT_EQ(measured->bytes, 1500u);
    EXPECT_DOUBLE_EQ(measured->seconds, 0.5);
}

TEST(TransferMeter, EachMomentCountsOnce) {
    TransferMeter meter;
    meter.wanted(tree, 1, 1000, 0.0);
    meter.wanted(tree, 2, 1000, 0.0);
    EXPECT_DOUBLE_EQ(held(meter, {1}, 1.0)->seconds, 1.0);
    EXPECT_DOUBLE_EQ(held(meter, {2}, 1.25)->seconds, 0.25);
    // No transfer ran until the worker asked again.
    meter.wanted(tree, 4, 1000, 7.0);
    EXPECT_DOUBLE_EQ(held(meter, {4}, 7.5)->seconds, 0.5);
}

TEST(TransferMeter, AskingAgainDoesNotBeginAnew) {
    TransferMeter meter;
    meter.wanted(tree, 1, 1000, 1.0);
    meter.wanted(tree, 1, 1000, 2.0);
    EXPECT_DOUBLE_EQ(held(meter, {1}, 3.0)->seconds, 2.0);
}

TEST(TransferMeter, ABlockThatWasNotWantedIsNoTransfer) {
    TransferMeter meter;
    EXPECT_FALSE(held(meter, {1}, 1.0));
    meter.wanted(tree, 1, 1000, 1.0);
    EXPECT_FALSE(meter.held(TreeId{4}, std::vector<RootIndex>{1}, 2.0));
    meter.tree_removed(tree);
    EXPECT_FALSE(held(meter, {1}, 3.0));
}

} // namespace
} // namespace cd::tests
