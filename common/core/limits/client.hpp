// Bounds of cdctl: what it queues, keeps and reads, and how long it waits.
#pragma once

#include <chrono>
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
inline constexpr std::chrono::milliseconds progress_period{100};
/// A step that takes longer is named in a line on stderr.
inline constexpr std::chrono::milliseconds slow_note_after{500};

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
inline constexpr std::chrono::seconds reader_seconds_min{20};
inline constexpr std::uint64_t reader_file_bytes_per_second = 1u << 20;
inline constexpr int reader_real_seconds_each = 10; ///< Wall clock per second of processor time.

// Caches and results folders.
/// Total size of the cached trees that are kept between runs.
inline constexpr std::uint64_t tree_cache_bytes_max = 4ull << 30;
/// Period in which a run flushes its results; a killed run loses later ones.
inline constexpr std::chrono::seconds record_flush_period{5};
/// Size of the meshes and poses kept in a results folder; if they are larger, none are kept.
inline constexpr std::uint64_t run_inputs_bytes_max = 1ull << 30;
/// A larger results folder needs --yes.
inline constexpr std::uint64_t folder_bytes_unasked_max = 1'000'000'000;

// A master.
/// Bytes of a mesh in one message of an upload.
inline constexpr std::size_t mesh_piece_bytes = 1u << 20;
/// While more is queued, cdctl waits before it sends more.
inline constexpr std::size_t client_write_queue_bytes_max = 4u << 20;
/// cdctl waits this long for an answer that costs the master no work.
inline constexpr std::chrono::seconds answer_timeout{30};
/// cdctl waits this long for the master to store a mesh or to accept a job.
inline constexpr std::chrono::seconds mesh_stored_timeout{3600};
// `cdctl watch` asks for the cluster's status after this time without news of its job.
inline constexpr std::chrono::seconds watch_look_period{1};
// Period in which `cdctl watch` asks for the cluster's status while there is news.
inline constexpr std::chrono::seconds watch_look_period_going_on{10};
/// After Ctrl-C, cdctl closes the connection if a call does not end within this time.
inline constexpr std::chrono::milliseconds stop_patience{1000};
/// cdctl retries a lost connection for this long.
inline constexpr std::chrono::seconds come_back_max{60};
inline constexpr std::chrono::milliseconds come_back_period{300}; ///< Pause between two attempts.
/// Connections in a row that brought damaged bytes; then cdctl stops awaiting the job's end.
inline constexpr int damaged_connections_max = 5;

// The cluster that `cdctl demo` starts on this host.
inline constexpr std::chrono::seconds local_start_max{
    30}; ///< Time for master and workers to start.
/// Pause between two looks at the processes.
inline constexpr std::chrono::milliseconds process_poll_period{10};

} // namespace cd::limits
