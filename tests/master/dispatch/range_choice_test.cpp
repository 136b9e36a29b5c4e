// Proves when ranges are preferred: never before measurements unless no block is missing, and
// otherwise if the missing blocks cost less than the matching that ranges save.
#include "master/dispatch/range_choice.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

RangeCosts small_cluster() {
    RangeCosts costs;
    costs.scenarios_left = 10'000;
    costs.analysis = 30e-6;
    costs.matching = 20e-6;
    costs.work = 100e-6;
    costs.threads_master = 4;
    costs.threads_workers = 4;
    costs.missing.matched = 0;
    costs.missing.any = 0;
    costs.missing.all = 0.01;
    return costs;
}

TEST(RangeChoice, WaitsForMeasures) {
    RangeCosts costs = small_cluster();
    EXPECT_TRUE(prefers_ranges(costs));
    costs.missing.any.reset();
    EXPECT_FALSE(prefers_ranges(costs));
}

TEST(RangeChoice, WorkersThatMissNothingNeedNoMeasures) {
    RangeCosts costs;
    costs.scenarios_left = 10'000;
    EXPECT_TRUE(prefers_ranges(costs));
    costs.threads_workers = 0;
    EXPECT_FALSE(prefers_ranges(costs)) << "nobody is known to hold the blocks";
}

TEST(RangeChoice, WeighsMissingBlocksAgainstTheMatching) {
    RangeCosts costs = small_cluster();
    costs.missing.matched = 100e-6;
    costs.missing.any = 110e-6;
    EXPECT_TRUE(prefers_ranges(costs)) << "10 us of blocks more, 20 us of matching less";
    costs.missing.any = 130e-6;
    EXPECT_FALSE(prefers_ranges(costs));
}

TEST(RangeChoice, FillingTheCachesIsPaidOnce) {
    RangeCosts costs = small_cluster();
    costs.missing.any = 1e-3;
    EXPECT_FALSE(prefers_ranges(costs)) << "the geometry is larger than the caches";
    costs.missing.all = 0.15;
    costs.missing.all_fits = true;
    EXPECT_TRUE(prefers_ranges(costs)) << "the matching of what is left takes 0.2 s";
    costs.scenarios_left = 5000;
    EXPECT_FALSE(prefers_ranges(costs));
}

TEST(RangeChoice, BytesOfTheAnalysisCountOnASlowLink) {
    RangeCosts costs = small_cluster();
    costs.missing.any = 130e-6;
    costs.analysed_bytes = 200;
    costs.missing.of_byte = 1e-8; // 2 us, and 20 us of matching.
    EXPECT_FALSE(prefers_ranges(costs));
    costs.missing.of_byte = 1e-6; // 200 us.
    EXPECT_TRUE(prefers_ranges(costs));
}

TEST(RangeChoice, WorkersThatWouldWaitForTheMasterCount) {
    RangeCosts costs = small_cluster();
    costs.missing.any = 100e-6;
    EXPECT_FALSE(prefers_ranges(costs));
    costs.threads_workers = 100; // The master feeds 50,000 a second, the workers do 770,000.
    EXPECT_TRUE(prefers_ranges(costs));
}

} // namespace
} // namespace cd::tests
