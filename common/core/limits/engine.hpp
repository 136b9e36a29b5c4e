// Bounds of meshes, trees, queries, poses and results.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cd::limits {

// Meshes and trees.
inline constexpr std::uint64_t mesh_vertices_max = 1ull << 31;
inline constexpr std::uint64_t mesh_triangles_max = 1ull << 31;
inline constexpr std::uint64_t mesh_bytes_max = 8ull << 30;
inline constexpr std::uint32_t parts_max = 1u << 20;
inline constexpr std::size_t bodies_max = 16'384;    ///< Bodies of a job.
inline constexpr std::size_t body_meshes_max = 4096; ///< Different meshes of a job's bodies.
inline constexpr std::uint32_t distribution_depth_max = 20;
inline constexpr std::uint64_t subtree_block_bytes_max = 1ull << 30;
/// A message of blocks gets no further block once its blocks have this size in total.
inline constexpr std::size_t subtrees_bytes_min = 1u << 20;
/// Estimated memory of a wide tree per triangle.
inline constexpr std::uint64_t wide_bytes_per_triangle = 48;
/// No valid wide tree is deeper: a child has at most 3/4 of its parent's triangles.
inline constexpr unsigned wide_tree_depth_max = 100;

// Queries.
inline constexpr std::uint64_t scenarios_max = 1ull << 40; ///< Scenarios of a job.
/// Crossings of lines that a map counts for a triangle.
inline constexpr std::uint64_t map_crossings_max = 1ull << 42;
/// Colliding pairs of distribution roots of one scenario; a scenario with more fails.
inline constexpr std::uint32_t root_pairs_max = 1u << 22;
/// Searches that a thread keeps for further scenarios of their pairs of trees.
inline constexpr std::size_t searches_kept_max = 16;
/// With more ignored pairs of parts of two bodies than this, no scenario is tested for class
/// `inside`.
inline constexpr std::size_t inside_ignored_max = 4096;
/// Two triangles of a body are of one kind if they are ignored with the same parts of the other
/// body. With more kinds than this, it is not decided whether the body is inside the other.
inline constexpr std::size_t inside_kinds_max = 256;

// Poses.
/// Poses are reordered within windows of so many, so that neighbours touch the same subtrees.
inline constexpr std::uint64_t order_window_scenarios = 1u << 16;
/// Number of scenarios whose poses are sent to the master together, stored and read. Divides the
/// size of a window.
inline constexpr std::uint64_t pose_run_scenarios = 4096;
/// Number of scenarios that the master analyses together.
inline constexpr std::uint64_t analysis_block_scenarios = 256;
/// Random poses are computed ahead of the run, in windows of so many scenarios per thread.
inline constexpr std::uint64_t computed_window_scenarios = 16;
/// Number of windows of random poses that are computed ahead of the run.
inline constexpr std::uint64_t computed_windows_max = 128;

// Scenes.
/// Rules of a job, and pairs of ranges of triangles that they ignore.
inline constexpr std::size_t scene_rules_max = 1u << 16;

// Motions.
/// The time between two keys is halved at most this often.
inline constexpr unsigned motion_depth_max = 19;
/// Cells that a search along a motion tests; the answer says up to where it is known.
inline constexpr std::uint32_t motion_cells_max = 1u << 16;

// Results.
/// Size of one scenario's record, small enough for a message.
inline constexpr std::uint64_t result_record_bytes_max = 1ull << 28;
/// Uncompressed size of all records in one message.
inline constexpr std::uint64_t results_bytes_max = 512u << 20;
/// Size of all records in one message that are not packed.
inline constexpr std::uint64_t plain_records_bytes_max = 16u << 20;
/// Pairs of parts in contact that a run sums; pairs of triangles in further ones are only counted.
inline constexpr std::size_t groups_max = 100'000;
inline constexpr std::size_t label_bytes_max = 256; ///< The id that a pose file gives a scenario.

} // namespace cd::limits
