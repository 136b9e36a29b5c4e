// Bounds of cdctl: what it queues, keeps and reads, and how long it waits.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

// A run on one machine.
inline constexpr std::uint64_t run_scenarios_ahead_max = 16384;  ///< Added and not yet taken.
inline constexpr std::uint64_t run_bytes_ahead_max = 256u << 20; ///< Results not yet taken.
inline constexpr std::size_t run_taken_at_once_max = 256;        ///< Results taken at a time.
inline constexpr std::size_t run_batch_scenarios_max = 64;     ///< Handed over by a thread at once.
inline constexpr std::uint64_t run_batch_bytes_max = 1u << 20; ///< Handed over by a thread at once.
inline constexpr std::uint64_t run_poses_at_once_max = 128;    ///< Read before results are taken.
inline constexpr std::chrono::milliseconds progress_period{100};
inline constexpr std::chrono::milliseconds slow_note_after{500}; ///< Then a line says what is slow.

// Mesh files.
inline constexpr std::uint64_t npz_array_bytes_max = 16ull << 30; ///< One array, unpacked.
inline constexpr std::size_t mesh_file_depth_max = 1000; ///< Nested nodes: importers recurse.
/// A polygon is too tangled to be triangulated if it needs more corner tests than this.
inline constexpr std::uint64_t polygon_tests_per_corner_max = 1u << 14;
// The process that reads a file by foreign code: memory and processor time grow with the file.
inline constexpr std::uint64_t reader_memory_bytes_min = 1ull << 30;
inline constexpr std::uint64_t reader_memory_per_file_byte = 512; ///< XML is unpacked from a zip.
inline constexpr std::chrono::seconds reader_seconds_min{20};
inline constexpr std::uint64_t reader_file_bytes_per_second = 1u << 20;
inline constexpr int reader_real_seconds_each = 10; ///< Wall clock for each processor second.

// Caches and results folders.
inline constexpr std::uint64_t tree_cache_bytes_max = 4ull << 30; ///< Trees kept between runs.
inline constexpr std::chrono::seconds record_flush_period{5};     ///< What a killed run may lose.
inline constexpr std::uint64_t run_inputs_bytes_max = 1ull << 30; ///< Kept beside the results.
inline constexpr std::uint64_t folder_bytes_unasked_max = 1'000'000'000; ///< More needs --yes.

// A master.
inline constexpr std::size_t mesh_piece_bytes = 1u << 20; ///< In one message of an upload.
inline constexpr std::size_t client_write_queue_bytes_max = 4u << 20; ///< Above it cdctl waits.
inline constexpr std::chrono::seconds answer_timeout{30};        ///< For answers that need no work.
inline constexpr std::chrono::seconds mesh_stored_timeout{3600}; ///< For answers that need work.
// Period of `watch`'s questions: the first if its job makes no progress, the second if it does.
inline constexpr std::chrono::seconds watch_look_period{1};
inline constexpr std::chrono::seconds watch_look_period_going_on{10};
inline constexpr std::chrono::milliseconds stop_patience{1000}; ///< For a call to end after Ctrl-C.
inline constexpr std::chrono::seconds come_back_max{60};        ///< For a master that went away.
inline constexpr std::chrono::milliseconds come_back_period{300};
inline constexpr int damaged_connections_max = 5; ///< In a row, while a job's end is awaited.

// A cluster of its own (`demo`).
inline constexpr std::chrono::seconds local_start_max{30};
inline constexpr std::chrono::milliseconds process_poll_period{10};

} // namespace cd::limits
