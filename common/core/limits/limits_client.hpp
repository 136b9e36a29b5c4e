// The bounds of cdctl: what it queues, and how long it waits.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

// A run on one machine. Scenarios that were added and not taken, and bytes of results among them.
inline constexpr std::uint64_t run_scenarios_ahead_max = 16384;
inline constexpr std::uint64_t run_bytes_ahead_max = 256u << 20;
/// What is taken at a time from there, and what a thread does before it hands over.
inline constexpr std::size_t run_taken_at_once_max = 256;
inline constexpr std::size_t run_batch_scenarios_max = 64;
inline constexpr std::uint64_t run_batch_bytes_max = 1u << 20;
inline constexpr std::chrono::milliseconds progress_period{100};
/// Preparing for longer prints a line that names the work.
inline constexpr std::chrono::milliseconds slow_note_after{500};
/// A local run adds at most so many poses before it takes results again.
inline constexpr std::uint64_t run_poses_at_once_max = 128;
/// A local run computes random poses ahead, in windows of so many scenarios.
inline constexpr std::uint64_t computed_window_scenarios = 16;
inline constexpr std::uint64_t computed_windows_max = 128; ///< Windows that wait or are kept.

/// A polygon that needs more tests of corners against ears, for each of its corners, is refused.
inline constexpr std::uint64_t polygon_tests_per_corner_max = 1u << 14;

// A results folder.
/// A killed run loses at most the results of this period.
inline constexpr std::chrono::seconds record_flush_period{5};
/// A folder keeps a job's meshes and poses only up to this size.
inline constexpr std::uint64_t run_inputs_bytes_max = 1ull << 30;
/// A run that would write more needs --yes.
inline constexpr std::uint64_t folder_bytes_unasked_max = 1'000'000'000;

// Talking to a master.
inline constexpr std::size_t mesh_piece_bytes = 1u << 20;             ///< Of one message.
inline constexpr std::size_t client_write_queue_bytes_max = 4u << 20; ///< Then it waits.
/// How often `watch` asks for the cluster's status while its job makes no progress.
inline constexpr std::chrono::seconds watch_look_period{1};
inline constexpr std::chrono::seconds watch_look_period_going_on{10}; ///< While it makes some.
/// How often a call that waits looks whether it has been stopped.
inline constexpr std::chrono::milliseconds stop_check_period{100};
/// After a stop, how long a call may take to end by itself.
inline constexpr std::chrono::milliseconds stop_patience{1000};
inline constexpr std::chrono::seconds come_back_max{60}; ///< For a master that went away.
inline constexpr std::chrono::milliseconds come_back_period{300};
inline constexpr int damaged_connections_max = 5; ///< One after the other, to see a job's end.

// A cluster of its own.
inline constexpr std::chrono::seconds local_start_max{30};
inline constexpr std::chrono::milliseconds process_poll_period{10};

} // namespace cd::limits
