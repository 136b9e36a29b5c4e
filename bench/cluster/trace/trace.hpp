// What the scenarios of one job and the subtrees of its two bodies cost, measured by real code:
// what a simulation of a cluster runs on.
#pragma once

#include "common/core/result.hpp"
#include "common/tree/cut.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cd::bench {

/// The subtree under one distribution root.
struct RootTrace {
    std::uint32_t triangles = 0;
    std::uint64_t bytes = 0;            ///< Its block, encoded,
    std::uint64_t compressed_bytes = 0; ///< and as it travels.
    std::uint64_t memory_bytes = 0;     ///< At a worker.
    double open_seconds = 0; ///< From what came to what can be searched: check, decode, wide tree.
};

/// A body cut at one depth.
struct CutTrace {
    std::uint32_t depth = 0;
    std::uint64_t top_bytes = 0; ///< Of the top's block, compressed.
    std::vector<RootTrace> roots;
};

/// A scenario at one depth of A's cut. Seconds are of processor time, medians of passes over
/// neighbouring scenarios, so that each finds in the caches what the one before it left there.
struct ScenarioTrace {
    double analysis_seconds = 0; ///< The master's step,
    std::uint64_t analysis_box_tests = 0;
    std::uint32_t root_pairs = 0;
    double meeting_size = 0;       ///< What the master's model of costs goes by (cost_model.hpp).
    double work_seconds = 0;       ///< The worker's step as it is: wide trees, and the record.
    double binary_seconds = 0;     ///< The same search in the paper's form of tree, the binary one.
    std::uint64_t batch_bytes = 0; ///< What the scenario adds to a batch,
    std::uint64_t result_bytes = 0; ///< and its record to the results, compressed.
    std::vector<RootIndex> roots_a; ///< Touched, ascending.
    std::vector<RootIndex> roots_b;
};

/// A scenario in one process, without cuts.
struct WholeTrace {
    double seconds = 0;               ///< In wide trees, with its record,
    double binary_seconds = 0;        ///< and the search in binary ones.
    std::uint64_t box_tests = 0;      ///< In binary trees: the paper's N_b,
    std::uint64_t triangle_tests = 0; ///< and N_p.
    std::uint64_t wide_box_tests = 0; ///< The same of the wide trees.
    std::uint64_t wide_triangle_tests = 0;
};

/// Of each scenario, on the mean: from the worker's search to the master's disk. Processor time.
struct ResultCosts {
    double packing_seconds = 0; ///< At the worker: records compressed, and made a message.
    double intake_seconds = 0;  ///< At the master: unpacked, checked, settled and hashed,
    double journal_seconds = 0; ///< merged, and written.
};

struct DepthTrace {
    CutTrace a;
    std::vector<ScenarioTrace> scenarios; ///< As many as `Trace::whole`, in the same order.
};

/// Numbers little-endian, compressed as one zstd frame inside a checked file (disk_file.hpp): the
/// members in the order in which they are declared; counts and whole numbers as varints, seconds
/// and sizes as f64, a list of roots as its length and the steps from root to root.
struct Trace {
    std::string name;
    std::uint64_t triangles_a = 0;
    std::uint64_t triangles_b = 0;
    double box_test_ns = 0;      ///< The paper's C_b, of the wide trees,
    double triangle_test_ns = 0; ///< and C_p.
    ResultCosts results;
    std::vector<WholeTrace> whole;
    CutTrace b;                     ///< At the one depth at which B is cut.
    std::vector<DepthTrace> depths; ///< Ascending.

    /// Null where A was not cut at that depth.
    [[nodiscard]] const DepthTrace* at(std::uint32_t depth_a) const;
};

/// Errors: Io.
[[nodiscard]] Status write_trace(const std::filesystem::path& path, const Trace& trace);
/// Errors: NotFound, Io.
[[nodiscard]] Result<Trace> read_trace(const std::filesystem::path& path);

} // namespace cd::bench
