// Proves that a trace is read back as written, and that the paper's seconds are reached row by row
// in any order of scenarios.
#include "bench/cluster/model/workload.hpp"

#include "bench/cluster/trace/trace.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <random>

namespace cd::tests {
namespace {

using namespace cd::bench;

Trace make_trace(std::size_t scenarios) {
    std::mt19937_64 random(5);
    const auto seconds = [&] { return 1e-6 * static_cast<double>(1 + random() % 1000); };
    Trace trace;
    trace.name = "made up";
    trace.triangles_a = 120;
    trace.triangles_b = 30;
    trace.box_test_ns = 2.5;
    trace.triangle_test_ns = 11;
    trace.results = {seconds(), seconds(), seconds()};
    trace.b = {6, 700, {{10, 300, 200, 900, seconds()}, {20, 600, 400, 1800, seconds()}}};
    DepthTrace depth;
    depth.a = {10, 5000, {{50, 1500, 900, 4000, seconds()}, {70, 2100, 1300, 5600, seconds()}}};
    for (std::size_t i = 0; i < scenarios; ++i) {
        trace.whole.push_back({seconds(), seconds(), 100 + i, 20, 300, 40});
        depth.scenarios.push_back(
            {seconds(), i, 3, 7.5, seconds(), seconds(), 250, 90 + i, {0, 1}, {1}});
    }
    trace.depths = {depth};
    return trace;
}

TEST(Workload, ATraceComesBackFromItsFile) {
    const auto path =
        std::filesystem::temp_directory_path() / ("cdcluster_trace_" + std::to_string(::getpid()));
    const Trace trace = make_trace(40);
    ASSERT_TRUE(write_trace(path, trace).has_value());
    const auto read = read_trace(path);
    std::filesystem::remove(path);
    ASSERT_TRUE(read.has_value()) << read.error().detail;

    EXPECT_EQ(read.value().name, trace.name);
    EXPECT_EQ(read.value().triangle_test_ns, trace.triangle_test_ns);
    EXPECT_EQ(read.value().results.packing_seconds, trace.results.packing_seconds);
    EXPECT_EQ(read.value().results.journal_seconds, trace.results.journal_seconds);
    ASSERT_EQ(read.value().whole.size(), 40u);
    EXPECT_EQ(read.value().whole[7].binary_seconds, trace.whole[7].binary_seconds);
    EXPECT_EQ(read.value().b.roots[1].memory_bytes, 1800u);
    const DepthTrace* depth = read.value().at(10);
    ASSERT_NE(depth, nullptr);
    EXPECT_EQ(depth->scenarios[39].result_bytes, 129u);
    EXPECT_EQ(depth->scenarios[39].meeting_size, 7.5);
    EXPECT_EQ(depth->scenarios[39].roots_a, (std::vector<RootIndex>{0, 1}));
    EXPECT_EQ(read.value().at(9), nullptr);
}

TEST(Workload, ThePapersSecondsAreReachedRowByRow) {
    const Trace trace = make_trace(paper_table_heavy.scenarios.back());
    for (const std::uint64_t seed : {1, 2, 3}) {
        for (std::size_t row = 0; row < paper_table_heavy.scenarios.size(); ++row) {
            const Workload workload =
                make_workload(trace,
                              paper_table_heavy,
                              {Costs::Paper, 10, paper_table_heavy.scenarios[row], seed});
            EXPECT_EQ(workload.count(), paper_table_heavy.scenarios[row]);
            EXPECT_NEAR(workload.serial_seconds, paper_table_heavy.fast_seconds[row], 1e-6);
        }
    }
}

TEST(Workload, AnotherSeedIsAnotherOrderOfTheSameScenarios) {
    const Trace trace = make_trace(100);
    const auto works = [&](std::uint64_t seed) {
        std::vector<double> seconds;
        const Workload workload =
            make_workload(trace, paper_table_heavy, {Costs::Measured, 10, 0, seed});
        for (const ScenarioCost& cost : workload.costs) {
            seconds.push_back(cost.work_seconds);
        }
        return seconds;
    };
    std::vector<double> first = works(1);
    std::vector<double> second = works(2);
    EXPECT_NE(first, second);
    EXPECT_EQ(second, works(2));
    std::ranges::sort(first);
    std::ranges::sort(second);
    EXPECT_EQ(first, second);
}

TEST(Workload, MeasuredCostsGoThroughTheTraceAgainAndAgain) {
    const Trace trace = make_trace(50);
    const Workload once = make_workload(trace, paper_table_heavy, {Costs::Measured, 10, 0, 1});
    const Workload thrice = make_workload(trace, paper_table_heavy, {Costs::Measured, 10, 150, 1});
    EXPECT_EQ(thrice.count(), 150u);
    EXPECT_EQ(thrice.costs.size(), 50u);
    EXPECT_NEAR(thrice.serial_seconds, 3 * once.serial_seconds, 1e-12);
    EXPECT_EQ(once.geometry_bytes, 900u + 1300u + 200u + 400u);
}

TEST(Workload, TheOrderThePredictionsAndTheAnalysisCanBeSet) {
    Trace trace = make_trace(50);
    for (std::size_t i = 0; i < 50; ++i) {
        trace.depths.front().scenarios[i].meeting_size = static_cast<double>((7 * i) % 50);
    }
    WorkloadOptions options{Costs::Measured, 10, 0, 2};
    options.longest_first = true;
    options.analysis_seconds = 0.5;
    const Workload sorted = make_workload(trace, paper_table_heavy, options);
    for (std::uint64_t i = 1; i < sorted.count(); ++i) {
        EXPECT_GE(sorted.scenario(i - 1).predicted_ns, sorted.scenario(i).predicted_ns);
        EXPECT_EQ(sorted.scenario(i).analysis_seconds, 0.5);
    }
    EXPECT_GT(sorted.scenario(0).predicted_ns, sorted.scenario(49).predicted_ns);
    options.equal_predictions = true;
    const Workload equal = make_workload(trace, paper_table_heavy, options);
    EXPECT_EQ(equal.scenario(0).predicted_ns, equal.scenario(49).predicted_ns);
    EXPECT_EQ(equal.scenario(7).work_seconds, sorted.scenario(7).work_seconds);
}

} // namespace
} // namespace cd::tests
