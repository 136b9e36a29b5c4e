// Bounds of cdctl: what it queues, keeps and reads, and how long it waits.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

// A run on one machine.
/// Scenarios whose results have not been taken yet; reading poses waits beyond that.
inline constexpr std::uint64_t run_scenarios_ahead_max = 16384;
/// Size of results that have not been taken yet; reading poses waits beyond that.
inline constexpr std::uint64_t run_bytes_ahead_max = 256u << 20;
inline constexpr std::size_t run_taken_at_once_max = 256; ///< Results taken in one call.
/// Results that a thread hands over at once.
inline constexpr std::size_t run_batch_scenarios_max = 64;
/// Size of the results that a thread hands over at once.
inline constexpr std::uint64_t run_batch_bytes_max = 1u << 20;
inline constexpr std::uint64_t run_poses_at_once_max = 128; ///< Read in one call.
inline constexpr std::chrono::milliseconds progress_period{100};
/// A step that takes longer is named in a line on stderr.
inline constexpr std::chrono::milliseconds slow_note_after{500};

// Mesh files.
/// An array of an NPZ file, uncompressed.
inline constexpr std::uint64_t npz_array_bytes_max = 16ull << 30;
/// Levels of nested nodes: importers recurse.
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
/// All cached trees together, between runs.
inline constexpr std::uint64_t tree_cache_bytes_max = 4ull << 30;
/// A run flushes its results so often; a killed run loses the later ones.
inline constexpr std::chrono::seconds record_flush_period{5};
/// Meshes and poses kept in a results folder; none are kept if there are more.
inline constexpr std::uint64_t run_inputs_bytes_max = 1ull << 30;
/// A larger results folder needs --yes.
inline constexpr std::uint64_t folder_bytes_unasked_max = 1'000'000'000;

// A master.
inline constexpr std::size_t mesh_piece_bytes = 1u << 20; ///< In one message of a mesh upload.
/// Above it cdctl waits before it sends more.
inline constexpr std::size_t client_write_queue_bytes_max = 4u << 20;
/// cdctl waits so long for an answer that costs the master no work.
inline constexpr std::chrono::seconds answer_timeout{30};
/// cdctl waits so long for the master to store a mesh or to accept a job.
inline constexpr std::chrono::seconds mesh_stored_timeout{3600};
// `cdctl watch` asks for the cluster's status after so long without news of its job.
inline constexpr std::chrono::seconds watch_look_period{1};
// While there is news, `cdctl watch` asks for the cluster's status so often.
inline constexpr std::chrono::seconds watch_look_period_going_on{10};
/// After Ctrl-C a call has so long to end; then cdctl closes the connection.
inline constexpr std::chrono::milliseconds stop_patience{1000};
/// cdctl retries a lost connection for so long.
inline constexpr std::chrono::seconds come_back_max{60};
inline constexpr std::chrono::milliseconds come_back_period{300}; ///< Between two attempts.
/// Connections in a row that brought damaged bytes; then cdctl stops awaiting the job's end.
inline constexpr int damaged_connections_max = 5;

// The cluster that `cdctl demo` starts on this host.
inline constexpr std::chrono::seconds local_start_max{30}; ///< For its master and workers to start.
/// Pause between two looks at the processes.
inline constexpr std::chrono::milliseconds process_poll_period{10};

} // namespace cd::limits
