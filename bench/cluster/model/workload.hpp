// A job for the simulation: the cost of each step in seconds and bytes.
#pragma once

#include "bench/cluster/trace/trace.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace cd::bench {

/// A subtree of the simulated job: its tree and its root.
struct BlockId {
    std::uint8_t tree = 0; ///< 0: A's, 1: B's.
    RootIndex root = 0;

    friend auto operator<=>(const BlockId&, const BlockId&) = default;
};

struct BlockCost {
    std::uint32_t triangles = 0;
    std::uint64_t bytes = 0;        ///< On the wire.
    std::uint64_t memory_bytes = 0; ///< In a worker's memory.
    double open_seconds = 0;
};

struct ScenarioCost {
    double analysis_seconds = 0;
    double work_seconds = 0; ///< On a fast core.
    std::uint64_t batch_bytes = 0;
    std::uint64_t result_bytes = 0;
    std::uint64_t predicted_ns = 0; ///< By the master's cost model.
    std::vector<BlockId> blocks;    ///< Ascending.
};

struct Workload {
    std::array<std::vector<BlockCost>, 2> trees;
    /// Upper trees, which workers need only for scenarios that the master has not analysed.
    std::array<BlockCost, 2> tops;
    std::vector<ScenarioCost> costs;
    /// Index into `costs` of each scenario, in submitted order.
    std::vector<std::uint32_t> scenarios;
    ResultCosts results;              ///< Measured costs; empty with the paper's costs.
    double serial_seconds = 0;        ///< The whole job in one process on a fast core.
    double slow_ratio = 1;            ///< Time on a slow core relative to a fast one.
    std::uint64_t geometry_bytes = 0; ///< Both bodies once, on the wire.

    [[nodiscard]] std::uint64_t count() const { return scenarios.size(); }
    [[nodiscard]] const ScenarioCost& scenario(std::uint64_t index) const {
        return costs[scenarios[index]];
    }
    [[nodiscard]] const BlockCost& block(const BlockId& id) const {
        return id.root == top_root ? tops[id.tree] : trees[id.tree][id.root];
    }
};

/// Rows of the paper's Table 2 or 3: seconds of one core of each kind after so many scenarios.
struct PaperTable {
    std::array<std::uint64_t, 5> scenarios;
    std::array<double, 5> fast_seconds;
    std::array<double, 5> slow_seconds;
};
extern const PaperTable paper_table_heavy; ///< Table 2.
extern const PaperTable paper_table_cars;  ///< Table 3.

/// Source of the costs.
enum class Costs : std::uint8_t {
    /// Searches: measured in binary trees, scaled for each fifth of the scenarios so that one
    /// process takes the seconds of the paper's table. Analyses (equal box tests) and predictions
    /// share one factor for all. Triangles take 207 bytes on the wire and in memory; opening costs
    /// nothing.
    Paper,
    /// As measured: wide trees, compressed blocks, opening, memory.
    Measured,
};

/// The paper's serialised trees: 62 MB for about 300,000 triangles and 19 MB for about 90,000.
inline constexpr std::uint64_t paper_bytes_per_triangle = 207;

struct WorkloadOptions {
    Costs costs = Costs::Paper;
    std::uint32_t depth_a = 10;
    /// Number of scenarios; 0: all of the trace. Larger numbers repeat the trace, only with
    /// measured costs.
    std::uint64_t count = 0;
    std::uint64_t seed = 1;         ///< 1 keeps the recorded order; another draws an order.
    double analysis_seconds = 0;    ///< Of each scenario; 0: as the costs say.
    bool longest_first = false;     ///< Submitted in descending order of the predictions.
    bool equal_predictions = false; ///< The master predicts the same time for all scenarios.
};

/// The trace must have the depth. A table row applies to an equal share of a trace of another
/// length.
[[nodiscard]] Workload
make_workload(const Trace& trace, const PaperTable& table, const WorkloadOptions& options);

} // namespace cd::bench
