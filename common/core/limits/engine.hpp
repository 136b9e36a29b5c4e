// Bounds of meshes, trees, queries and results: what common/ enforces.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

// Meshes and trees.
inline constexpr std::uint64_t mesh_vertices_max = 1ull << 31;
inline constexpr std::uint64_t mesh_triangles_max = 1ull << 31;
inline constexpr std::uint64_t mesh_bytes_max = 8ull << 30;
inline constexpr std::uint32_t parts_max = 1u << 20;
inline constexpr std::uint32_t distribution_depth_max = 20;
inline constexpr std::uint64_t subtree_block_bytes_max = 1ull << 30;
inline constexpr std::size_t subtrees_bytes_min = 1u << 20;  ///< A message gathers blocks up to it.
inline constexpr std::uint64_t wide_bytes_per_triangle = 48; ///< In memory; an estimate.
inline constexpr unsigned wide_tree_depth_max = 100; ///< A child has at most 3/4 of its parent.

// Queries.
inline constexpr std::uint64_t scenarios_max = 1ull << 40; ///< In one job.
inline constexpr std::uint32_t root_pairs_max = 1u << 22;  ///< A scenario; more is an error.
/// With more ignored pairs of parts, containment is not decided.
inline constexpr std::size_t inside_ignored_max = 4096;
/// Triangles of a body are of one kind if the same parts of the other body are ignored with them.
/// With more kinds, containment is not decided.
inline constexpr std::size_t inside_kinds_max = 256;
/// A call that waits checks this often whether it has been stopped.
inline constexpr std::chrono::milliseconds stop_check_period{100};

// Poses.
/// Poses are reordered within windows of this size, so that neighbours touch the same subtrees.
inline constexpr std::uint64_t order_window_scenarios = 1u << 16;
inline constexpr std::uint64_t analysis_block_scenarios = 256; ///< Analysed together.
/// Random poses are computed ahead of the run: scenarios of one window, which one thread computes.
inline constexpr std::uint64_t computed_window_scenarios = 16;
/// Most windows of random poses that are computed ahead of the run.
inline constexpr std::uint64_t computed_windows_max = 128;

// Results.
inline constexpr std::uint64_t result_record_bytes_max = 1ull << 28; ///< Fits a message.
inline constexpr std::uint64_t results_bytes_max = 512u << 20; ///< Of one message, uncompressed.
inline constexpr std::size_t label_bytes_max = 256;            ///< A scenario's id.

} // namespace cd::limits
