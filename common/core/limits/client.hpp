// Bounds of cdctl: what it queues, keeps and reads.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cd::limits {

// A run on one machine.
/// Number of results that have not been taken yet; with more, reading poses waits.
inline constexpr std::uint64_t run_scenarios_ahead_max = 16384;
/// Size of results that have not been taken yet; with more, reading poses waits.
inline constexpr std::uint64_t run_bytes_ahead_max = 256u << 20;
inline constexpr std::size_t run_taken_at_once_max = 256; ///< Results taken in one call.
/// Number of results that a thread hands over together.
inline constexpr std::size_t run_batch_scenarios_max = 64;
/// Size of the results that a thread hands over together.
inline constexpr std::uint64_t run_batch_bytes_max = 1u << 20;
inline constexpr std::uint64_t run_poses_at_once_max = 128; ///< Poses read in one call.

// Mesh files.
/// Uncompressed size of an array in an NPZ file.
inline constexpr std::uint64_t npz_array_bytes_max = 16ull << 30;
/// Depth of nested nodes, limited because importers recurse.
inline constexpr std::size_t mesh_file_depth_max = 1000;
/// A polygon is too tangled to be triangulated if it needs more corner tests than this.
inline constexpr std::uint64_t polygon_tests_per_corner_max = 1u << 14;
// The child process that reads a mesh file with assimp: its memory and processor time may grow with
// the file.
inline constexpr std::uint64_t reader_memory_bytes_min = 1ull << 30;
/// Memory per byte of the file: much, as zipped XML grows when unpacked.
inline constexpr std::uint64_t reader_memory_per_file_byte = 512;
inline constexpr std::uint64_t reader_file_bytes_per_second = 1u << 20;
inline constexpr int reader_real_seconds_each = 10; ///< Wall clock per second of processor time.

// Caches and results folders.
/// Total size of the cached trees that are kept between runs.
inline constexpr std::uint64_t tree_cache_bytes_max = 4ull << 30;
/// Size of the meshes and poses kept in a results folder; if they are larger, none are kept.
inline constexpr std::uint64_t run_inputs_bytes_max = 1ull << 30;
/// A larger results folder needs --yes.
inline constexpr std::uint64_t folder_bytes_unasked_max = 1'000'000'000;

// A master.
/// Bytes of a mesh in one message of an upload.
inline constexpr std::size_t mesh_piece_bytes = 1u << 20;
/// While more is queued, cdctl waits before it sends more.
inline constexpr std::size_t client_write_queue_bytes_max = 4u << 20;
/// Connections in a row that brought damaged bytes; then cdctl stops awaiting the job's end.
inline constexpr int damaged_connections_max = 5;

} // namespace cd::limits
