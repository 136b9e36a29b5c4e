// Proves that a job on many simulated hosts is answered completely, within its bounds and
// reproducibly, even if blocks exceed the caches; and that the baselines compute what they claim.
#include "bench/cluster/model/large_cluster.hpp"

#include "bench/cluster/model/baselines.hpp"
#include "bench/cluster/model/strategies.hpp"
#include "tests/bench/cluster/synthetic.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

namespace cd::tests {
namespace {

using namespace cd::bench;

LargeOptions some_hosts(std::string_view strategy, bool peers) {
    LargeOptions options;
    options.speeds.assign(30, 1.0);
    for (std::size_t host = 0; host < 30; host += 3) {
        options.speeds[host] = 0.2;
    }
    options.dispatch.strategy = strategy;
    options.dispatch.claim = false;
    options.dispatch.q = 4;
    options.peers = peers;
    return options;
}

TEST(LargeCluster, IsWholeWithinItsBoundsAndTheSameEachTime) {
    const Workload workload = make_synthetic_workload(7, 2000);
    for (const ComparedStrategy& compared : compared_strategies) {
        for (const bool peers : {false, true}) {
            SCOPED_TRACE(testing::Message() << compared.name() << " " << peers);
            LargeOptions options = some_hosts(compared.strategy, peers);
            options.dispatch.claim = compared.claims;
            const LargeOutcome first = simulate_large(workload, options);
            const LargeOutcome second = simulate_large(workload, options);
            EXPECT_EQ(first.answered, workload.count());
            EXPECT_EQ(first.seconds, second.seconds);
            EXPECT_EQ(first.sent_bytes, second.sent_bytes);
            EXPECT_EQ(first.peer_bytes != 0, peers);
            EXPECT_EQ(first.blocks_again, 0u);
            const BaselineOutcome optimum =
                offline_optimum(workload, options.speeds, options.bytes_per_second);
            EXPECT_GT(first.seconds, optimum.seconds);
            EXPECT_GE(first.block_bytes, optimum.sent_bytes);
            EXPECT_LT(first.seconds, workload.serial_seconds);
            EXPECT_EQ(first.evictions, 0u);
        }
    }
}

TEST(LargeCluster, RangesAreWholeAndEachBlockLeavesTheMasterOnce) {
    Workload workload = make_synthetic_workload(9, 20'000);
    workload.tops = {{{0, 5000, 0, 0}, {0, 3000, 0, 0}}};
    workload.geometry_bytes += 8000;
    for (ScenarioCost& cost : workload.costs) {
        cost.work_seconds *= 0.05;
    }
    workload.serial_seconds *= 0.05;
    LargeOptions options = some_hosts("earliest-finish", true);
    options.threads = 4;
    options.analysis = AnalysisMode::Never;
    options.at_once_seconds = 0.001;
    options.result_seconds = 1e-6;
    const LargeOutcome first = simulate_large(workload, options);
    const LargeOutcome second = simulate_large(workload, options);
    EXPECT_EQ(first.answered, workload.count());
    EXPECT_EQ(first.uploads_max, 1u);
    EXPECT_EQ(first.block_bytes, workload.geometry_bytes);
    EXPECT_EQ(first.seconds, second.seconds);
    const double power = 4 * std::accumulate(options.speeds.begin(), options.speeds.end(), 0.0);
    EXPECT_GT(first.seconds, workload.serial_seconds / power);
    EXPECT_LT(first.seconds, workload.serial_seconds);
    options.peers = false;
    EXPECT_GT(simulate_large(workload, options).uploads_max, 1u);
}

// With more than 64 workers, an event makes the master look for work for one worker only, not for
// all. The job must end nevertheless.
TEST(LargeCluster, JobsInRangesEndWithMoreHostsThanTheMasterLooksAtTogether) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937_64 random(seed);
        Workload workload = make_synthetic_workload(seed, 3000);
        for (ScenarioCost& cost : workload.costs) {
            cost.work_seconds *= 0.02;
        }
        LargeOptions options;
        options.dispatch.strategy = "earliest-finish";
        options.dispatch.claim = false;
        options.analysis = AnalysisMode::Never;
        options.at_once_seconds = 0.001;
        for (std::size_t host = 0; host < 100; ++host) {
            options.speeds.push_back(0.05 * static_cast<double>(1 + random() % 20));
        }
        EXPECT_EQ(simulate_large(workload, options).answered, workload.count());
    }
}

TEST(LargeCluster, BlocksThatDoNotFitComeAgain) {
    const Workload workload = make_synthetic_workload(8, 1000);
    for (const bool peers : {false, true}) {
        LargeOptions options = some_hosts("earliest-finish", peers);
        options.cache_bytes = 60'000; // All blocks have 256,000.
        const LargeOutcome outcome = simulate_large(workload, options);
        EXPECT_EQ(outcome.answered, workload.count());
        EXPECT_GT(outcome.evictions, 0u);
    }
}

TEST(Baselines, AreCountedInTheirOwnFavour) {
    Workload workload;
    workload.trees[0] = {{10, 1000, 5000, 0}, {10, 3000, 7000, 0}};
    workload.geometry_bytes = 4000;
    for (std::uint32_t i = 0; i < 4; ++i) {
        workload.costs.push_back({0, 1.0, 10, 10, 1, {{0, i / 2}}});
        workload.scenarios.push_back(i);
    }
    const std::vector<double> speeds{1, 0.5};
    // In the first 2 s each gets 1,000 bytes, then the second gets 2,000 more; its work takes 4 s.
    const BaselineOutcome split = static_split(workload, speeds, 1000);
    EXPECT_DOUBLE_EQ(split.seconds, 4);
    EXPECT_EQ(split.sent_bytes, 4000u);
    EXPECT_EQ(split.memory_bytes_max, 7000u);
    // The first is ready after 4 s and does all 4 scenarios before the second would be ready.
    EXPECT_DOUBLE_EQ(whole_everywhere(workload, speeds, 1000).seconds, 8);
    EXPECT_EQ(whole_everywhere(workload, speeds, 1000).sent_bytes, 8000u);
    // Work takes 4 s at speed 1.5; bytes take 4 s.
    EXPECT_DOUBLE_EQ(offline_optimum(workload, speeds, 1000).seconds, 4);
}

} // namespace
} // namespace cd::tests
