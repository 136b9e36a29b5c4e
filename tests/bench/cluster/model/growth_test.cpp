// Compares the master's estimate of more workers with simulated clusters: hosts join while a job
// runs, and the simulation tells how much sooner it ends.
#include "bench/cluster/model/large_cluster.hpp"
#include "tests/bench/cluster/synthetic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>

namespace cd::tests {
namespace {

using namespace cd::bench;

struct GrowthCase {
    const char* name;
    std::size_t hosts;
    std::size_t scenarios;
    std::string_view strategy;
    double result_seconds;
    double bytes_per_second;
    double error_max; ///< Of the predicted ratio of times, as measured, rounded up.
};

/// Scenarios of 1 to 9 ms. Longer ones would be sent longest first, so that the time of the first
/// ones would say little about the rest.
Workload short_scenarios(std::size_t count) {
    Workload workload = make_synthetic_workload(5, count);
    for (ScenarioCost& cost : workload.costs) {
        cost.analysis_seconds /= 10;
        cost.work_seconds /= 10;
        cost.predicted_ns /= 10;
    }
    return workload;
}

/// Time that is left from the moment at which so many hosts join.
double left_with(const Workload& workload, LargeOptions options, std::size_t more) {
    options.late.speeds.assign(more, 1);
    const LargeOutcome outcome = simulate_large(workload, options);
    EXPECT_EQ(outcome.answered, workload.count());
    return outcome.seconds - outcome.joined_seconds;
}

class GrowthOf : public testing::TestWithParam<GrowthCase> {};

TEST_P(GrowthOf, ACluster) {
    const GrowthCase& given = GetParam();
    const Workload workload = short_scenarios(given.scenarios);
    LargeOptions options;
    options.speeds.assign(given.hosts, 1);
    options.dispatch.strategy = given.strategy;
    options.dispatch.claim = false;
    options.dispatch.v_kb = 1000;
    options.result_seconds = given.result_seconds;
    options.bytes_per_second = given.bytes_per_second;
    options.late.share = 0.2;
    const LargeOutcome now = simulate_large(workload, options);
    ASSERT_TRUE(now.growth.has_value());
    const double left = now.seconds - now.joined_seconds;
    EXPECT_NEAR(now.growth->seconds / left, 1, 0.25);
    for (const GrowthPoint& point : now.growth->more) {
        if (point.workers > 4 * given.hosts) {
            break;
        }
        const double simulated = left / left_with(workload, options, point.workers);
        const double predicted = now.growth->seconds / point.seconds;
        std::printf(
            "%s: %zu hosts, %u more: %.3f times predicted, %.3f simulated, error %+.1f %%\n",
            given.name,
            given.hosts,
            point.workers,
            predicted,
            simulated,
            100 * (predicted / simulated - 1));
        EXPECT_NEAR(predicted / simulated, 1, given.error_max);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Simulated,
    GrowthOf,
    testing::Values(GrowthCase{"small", 4, 4000, "earliest-finish", 0, 125e6, 0.08},
                    GrowthCase{"middle", 16, 16'000, "earliest-finish", 0, 125e6, 0.08},
                    GrowthCase{"large", 64, 32'000, "earliest-finish", 0, 125e6, 0.08},
                    GrowthCase{"busy master", 16, 16'000, "earliest-finish", 1e-4, 125e6, 0.08},
                    GrowthCase{"slow network", 16, 16'000, "earliest-finish", 0, 5e6, 0.2},
                    GrowthCase{"best match", 16, 16'000, "best-match", 0, 125e6, 0.08}),
    [](const auto& given) {
        std::string name = given.param.name;
        std::replace(name.begin(), name.end(), ' ', '_');
        return name;
    });

} // namespace
} // namespace cd::tests
