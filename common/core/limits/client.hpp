// Bounds of the data that cdctl queues, keeps and reads.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cd::limits {

// A run on one machine.
/// Poses are read at most this many scenarios ahead of the next result in order.
inline constexpr std::uint64_t run_scenarios_ahead_max = 16384;
/// Size of the results that wait for their turn; with more, no poses are read.
inline constexpr std::uint64_t run_bytes_ahead_max = 256u << 20;
/// Number of results that a thread adds to the queue of results together.
inline constexpr std::size_t run_batch_scenarios_max = 1024;
/// Size of the results that a thread adds to the queue of results together.
inline constexpr std::uint64_t run_batch_bytes_max = 1u << 20;
inline constexpr std::uint64_t run_poses_at_once_max = 128; ///< Poses read in one call.
/// Shorter runs would gain less from support points than it costs to make them.
inline constexpr std::uint64_t run_points_scenarios_min = 100'000;

// Mesh files.
/// Uncompressed size of an array in an NPZ file.
inline constexpr std::uint64_t npz_array_bytes_max = 16ull << 30;
/// Depth of nested nodes in a mesh file, limited because importers recurse.
inline constexpr std::size_t mesh_file_depth_max = 1000;
/// Corner tests per corner of a polygon; if it needs more, the polygon is not triangulated.
inline constexpr std::uint64_t polygon_tests_per_corner_max = 1u << 14;
// The child process that reads a mesh file with assimp. The limits of its memory and processor time
// grow with the file.
inline constexpr std::uint64_t reader_memory_bytes_min = 1ull << 30;
/// Memory per byte of the file. The value is large because zipped XML grows when unpacked.
inline constexpr std::uint64_t reader_memory_per_file_byte = 512;
inline constexpr std::uint64_t reader_file_bytes_per_second = 1u << 20;
inline constexpr int reader_real_seconds_each = 10; ///< Wall clock per second of processor time.

// Traffic of SUMO.
inline constexpr std::size_t fcd_depth_max = 64; ///< Depth of nested XML elements.
/// Size of a tag or comment, which is in memory whole.
inline constexpr std::size_t fcd_markup_bytes_max = 1u << 20;

// Bundles of lines.
inline constexpr std::uint32_t bundle_side_max = 4096;      ///< Lines along a side of a tile.
inline constexpr std::uint64_t bundle_poses_max = 1u << 24; ///< Poses of one bundle in a job.

// Caches and results folders.
/// Total size of the trees, and of the meshes, that a cache keeps between runs.
inline constexpr std::uint64_t tree_cache_bytes_max = 4ull << 30;
/// Total size of a job's meshes and poses up to which a results folder keeps them.
inline constexpr std::uint64_t run_inputs_bytes_max = 1ull << 30;
/// If the results folder is estimated to become larger, `cdctl run` needs --yes.
inline constexpr std::uint64_t folder_bytes_unasked_max = 1'000'000'000;

// Watching a job on a master.
/// Scenarios of a job whose results are read for the least distance, some 100 bytes each.
inline constexpr std::uint64_t watch_scenarios_max = 1u << 20;

// Groups of contacts.
/// Connected pieces of a mesh that are parts of their own.
inline constexpr std::size_t pieces_max = 1000;
/// Numbers of triangles that groups keep to count regions; with more, regions are not counted.
inline constexpr std::uint64_t group_triangles_max = 1u << 26;
inline constexpr std::size_t group_episodes_max = 100; ///< Episodes that a group keeps.

// Comparing runs.
/// Number of scenarios whose records in an earlier run are read ahead together, if that run has
/// them in another order.
inline constexpr std::uint64_t compared_window_scenarios_max = 1u << 18;
inline constexpr std::uint64_t compared_ahead_bytes_max = 128u << 20; ///< Size of these records.

// Reports.
inline constexpr std::uint64_t report_bytes_max = 5'000'000; ///< Of a report without a viewer.
inline constexpr std::uint64_t report_with_viewer_bytes_max = 25'000'000;
/// Size of all pictures in a report. In the report they take a third more: half of its size.
inline constexpr std::size_t report_pictures_bytes_max = 1'800'000;
inline constexpr std::size_t report_groups_max = 200;      ///< Groups in the table of a report.
inline constexpr std::size_t report_warnings_max = 20;     ///< Warnings about statuses in a report.
inline constexpr std::size_t report_text_bytes_max = 2048; ///< A warning, a command, a path.
/// Scenarios that the viewer in a report can show.
inline constexpr std::size_t report_viewer_scenarios_max = 20;
/// Parts of A, and of B, in the matrix of a report.
inline constexpr std::size_t report_parts_max = 16;
inline constexpr std::size_t report_job_bytes_max = 65536; ///< Text of the job file in a report.

// A master.
/// Bytes of a mesh in one message of an upload.
inline constexpr std::size_t mesh_piece_bytes = 1u << 20;
/// cdctl sends no further data while more than this is queued for the master.
inline constexpr std::size_t client_write_queue_bytes_max = 4u << 20;
/// After so many connections in a row with damaged bytes, cdctl stops waiting for the job's end.
inline constexpr int damaged_connections_max = 5;

} // namespace cd::limits
