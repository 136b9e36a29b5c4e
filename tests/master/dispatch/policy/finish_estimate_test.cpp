// Proves that an estimate counts each cost once, in seconds, and nothing that is free.
#include "master/dispatch/policy/finish_estimate.hpp"

#include "common/core/timing/master.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

WorkerPowers some_powers() {
    WorkerPowers powers;
    powers.speed = 2;
    powers.bytes_per_second = 1e6;
    powers.threads = 4;
    powers.backlog_ns = 8e9;
    powers.transfers_seconds = 0.5;
    powers.room_bytes = 1000;
    return powers;
}

TEST(FinishEstimate, IsTheSumOfItsTerms) {
    ScenarioNeeds needs;
    needs.cost_ns = 3'000'000'000;
    needs.missing_bytes = 250'000;
    needs.missing_blocks = 10;
    needs.coming_bytes = 100'000;
    needs.bytes_of_memory = 50; // The blocks take 5,000 in the cache, which has room for 1,000.
    const FinishTerms terms = estimate_finish(some_powers(), needs);
    EXPECT_DOUBLE_EQ(terms.backlog, 1);
    EXPECT_DOUBLE_EQ(terms.coming, 0.1);
    EXPECT_DOUBLE_EQ(terms.transfer, 0.25);
    EXPECT_DOUBLE_EQ(terms.blocks, 10 * timing::block_seconds);
    EXPECT_DOUBLE_EQ(terms.eviction, 0.2); // The evicted 4,000 must be sent again.
    EXPECT_DOUBLE_EQ(terms.work, 1.5);     // On one thread.
    EXPECT_DOUBLE_EQ(terms.total(), 3.05 + 10 * timing::block_seconds);
}

TEST(FinishEstimate, BlocksUnderWayCountNoLongerThanUntilTheyAreThere) {
    ScenarioNeeds needs;
    needs.coming_bytes = 10'000'000;
    EXPECT_DOUBLE_EQ(estimate_finish(some_powers(), needs).coming, 0.5);
    WorkerPowers powers = some_powers();
    powers.transfers_seconds = 0;
    EXPECT_EQ(estimate_finish(powers, needs).coming, 0);
}

TEST(FinishEstimate, BlocksThatFitTheCacheEvictNothing) {
    ScenarioNeeds needs;
    needs.missing_bytes = 1000;
    needs.bytes_of_memory = 1;
    EXPECT_EQ(estimate_finish(some_powers(), needs).eviction, 0);
}

} // namespace
} // namespace cd::tests
