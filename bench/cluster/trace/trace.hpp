// Measured costs of one job's scenarios and of the two bodies' subtrees: the input of cluster
// simulations.
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
    std::uint64_t bytes = 0;            ///< Encoded block.
    std::uint64_t compressed_bytes = 0; ///< Block on the wire.
    std::uint64_t memory_bytes = 0;     ///< In a worker's memory.
    double open_seconds = 0;            ///< Check, decode, and building of the wide tree.
};

/// A body cut at one depth.
struct CutTrace {
    std::uint32_t depth = 0;
    std::uint64_t top_bytes = 0; ///< Compressed block of the upper tree.
    std::vector<RootTrace> roots;
};

/// A scenario at one depth of A's cut. Seconds are processor time: medians of passes over
/// neighbouring scenarios, so that each finds the previous one's data in the caches.
struct ScenarioTrace {
    double analysis_seconds = 0; ///< The master's step.
    std::uint64_t analysis_box_tests = 0;
    std::uint32_t root_pairs = 0;
    double meeting_size = 0;        ///< Input of the master's cost model (cost_model.hpp).
    double work_seconds = 0;        ///< The worker's real step: wide trees, and the record.
    double binary_seconds = 0;      ///< The search in binary trees, the paper's form.
    std::uint64_t batch_bytes = 0;  ///< Bytes that the scenario adds to a batch.
    std::uint64_t result_bytes = 0; ///< Compressed bytes of its record in the results.
    std::vector<RootIndex> roots_a; ///< Touched roots, ascending.
    std::vector<RootIndex> roots_b;
};

/// A scenario in one process, without cuts.
struct WholeTrace {
    double seconds = 0;               ///< In wide trees, with the record.
    double binary_seconds = 0;        ///< The search in binary trees.
    std::uint64_t box_tests = 0;      ///< The paper's N_b, in binary trees.
    std::uint64_t triangle_tests = 0; ///< The paper's N_p, in binary trees.
    std::uint64_t wide_box_tests = 0; ///< N_b in wide trees.
    std::uint64_t wide_triangle_tests = 0;
};

/// Mean processor time per scenario, from the worker's search to the master's disk.
struct ResultCosts {
    double packing_seconds = 0; ///< At the worker: records compressed and made a message.
    double intake_seconds = 0;  ///< At the master: results unpacked, checked, settled and hashed.
    double journal_seconds = 0; ///< At the master: results merged and written.
};

struct DepthTrace {
    CutTrace a;
    std::vector<ScenarioTrace> scenarios; ///< As many as `Trace::whole`, in that order.
};

/// File format: one zstd frame in a checked file (disk_file.hpp), little-endian, with the members
/// in the order of declaration. Counts and whole numbers are varints, seconds and sizes f64; a list
/// of roots is its length and the steps from root to root.
struct Trace {
    std::string name;
    std::uint64_t triangles_a = 0;
    std::uint64_t triangles_b = 0;
    double box_test_ns = 0;      ///< The paper's C_b, in wide trees.
    double triangle_test_ns = 0; ///< The paper's C_p, in wide trees.
    ResultCosts results;
    std::vector<WholeTrace> whole;
    CutTrace b;                     ///< At B's only depth.
    std::vector<DepthTrace> depths; ///< Ascending.

    /// Null if A was not cut at that depth.
    [[nodiscard]] const DepthTrace* at(std::uint32_t depth_a) const;
};

/// Errors: Io.
[[nodiscard]] Status write_trace(const std::filesystem::path& path, const Trace& trace);
/// Errors: NotFound, Io.
[[nodiscard]] Result<Trace> read_trace(const std::filesystem::path& path);

} // namespace cd::bench
