// Bounds of meshes, trees, queries and results: what common/ enforces.
#pragma once

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
/// A message of blocks is sent once the blocks reach this size.
inline constexpr std::size_t subtrees_bytes_min = 1u << 20;
/// Estimated memory of a wide tree.
inline constexpr std::uint64_t wide_bytes_per_triangle = 48;
/// No valid tree is deeper: a child has at most 3/4 of its parent's triangles.
inline constexpr unsigned wide_tree_depth_max = 100;

// Queries.
inline constexpr std::uint64_t scenarios_max = 1ull << 40; ///< In one job.
/// Colliding pairs of distribution roots of a scenario; more is an error.
inline constexpr std::uint32_t root_pairs_max = 1u << 22;
/// With more ignored pairs of parts, it is not decided whether a body is inside the other.
inline constexpr std::size_t inside_ignored_max = 4096;
/// Triangles of a body are of one kind if the same parts of the other body are ignored with them.
/// With more kinds, it is not decided whether a body is inside the other.
inline constexpr std::size_t inside_kinds_max = 256;

// Poses.
/// Poses are reordered within windows of this size, so that neighbours touch the same subtrees.
inline constexpr std::uint64_t order_window_scenarios = 1u << 16;
/// Number of scenarios that the master analyses together.
inline constexpr std::uint64_t analysis_block_scenarios = 256;
/// Random poses are computed ahead of the run; one thread computes a window of this many scenarios.
inline constexpr std::uint64_t computed_window_scenarios = 16;
/// Most windows of random poses that are computed ahead of the run.
inline constexpr std::uint64_t computed_windows_max = 128;

// Results.
/// Size of one scenario's record, which fits a message.
inline constexpr std::uint64_t result_record_bytes_max = 1ull << 28;
/// Uncompressed size of all records of one message.
inline constexpr std::uint64_t results_bytes_max = 512u << 20;
inline constexpr std::size_t label_bytes_max = 256; ///< The id that a pose file gives a scenario.

} // namespace cd::limits
