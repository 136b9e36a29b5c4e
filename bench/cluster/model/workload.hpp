// A job as the simulation runs it: what each of its steps costs in seconds and bytes.
#pragma once

#include "bench/cluster/trace/trace.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace cd::bench {

/// A subtree of the simulated job: which of the two trees, and which root of it.
struct BlockId {
    std::uint8_t tree = 0; ///< 0: A's, 1: B's.
    RootIndex root = 0;

    friend auto operator<=>(const BlockId&, const BlockId&) = default;
};

struct BlockCost {
    std::uint32_t triangles = 0;
    std::uint64_t bytes = 0;        ///< As it travels.
    std::uint64_t memory_bytes = 0; ///< At a worker.
    double open_seconds = 0;
};

struct ScenarioCost {
    double analysis_seconds = 0;
    double work_seconds = 0; ///< On a fast core.
    std::uint64_t batch_bytes = 0;
    std::uint64_t result_bytes = 0;
    std::uint64_t predicted_ns = 0; ///< By the master's model of costs.
    std::vector<BlockId> blocks;    ///< Ascending.
};

struct Workload {
    std::array<std::vector<BlockCost>, 2> trees;
    std::vector<ScenarioCost> costs;
    std::vector<std::uint32_t> scenarios; ///< As submitted: the place in `costs` of each.
    ResultCosts results;                  ///< As measured; nothing with the paper's costs.
    double serial_seconds = 0;            ///< All of it in one process on a fast core,
    double slow_ratio = 1;                ///< and how many times as long on a slow core.
    std::uint64_t geometry_bytes = 0;     ///< Of both bodies once, as they travel.

    [[nodiscard]] std::uint64_t count() const { return scenarios.size(); }
    [[nodiscard]] const ScenarioCost& scenario(std::uint64_t index) const {
        return costs[scenarios[index]];
    }
    [[nodiscard]] const BlockCost& block(const BlockId& id) const {
        return trees[id.tree][id.root];
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

/// Where costs come from.
enum class Costs : std::uint8_t {
    /// Searches in binary trees as measured, with one factor for each fifth of the scenarios, by
    /// which one process takes the seconds of the paper's table; analyses (the same box tests) with
    /// one factor for all, and predictions with the same; 207 bytes for each triangle on the wire
    /// and in memory; opening
    /// cost nothing.
    Paper,
    /// As measured: wide trees, compressed blocks, opening, memory.
    Measured,
};

/// The paper's serialised trees: 62 MB for about 300,000 triangles and 19 MB for about 90,000.
inline constexpr std::uint64_t paper_bytes_per_triangle = 207;

struct WorkloadOptions {
    Costs costs = Costs::Paper;
    std::uint32_t depth_a = 10;
    /// Of scenarios; 0: as many as the trace has. More are had only at measured costs, by going
    /// through the trace again and again.
    std::uint64_t count = 0;
    std::uint64_t seed = 1; ///< 1 keeps the recorded order; another draws an order.
};

/// The trace has the depth. A row of the table stands for the same share of a trace of another
/// length.
[[nodiscard]] Workload
make_workload(const Trace& trace, const PaperTable& table, const WorkloadOptions& options);

} // namespace cd::bench
