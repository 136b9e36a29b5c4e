// Bounds of a worker's process.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

// Work.
inline constexpr std::size_t jobs_per_thread_max = 4; ///< Scenarios and descents begun or queued.
/// A thread takes scenarios of a range for about this time at once.
inline constexpr double walk_seconds = 0.001;
inline constexpr std::size_t walk_scenarios_max = 256; ///< Taken at once by a thread.
/// Scenarios that wait for subtrees. With more, the worker descends the upper trees for no further
/// scenario.
inline constexpr std::size_t walked_waiting_max = 4096;
/// A binary subtree in memory; an estimate.
inline constexpr std::uint64_t binary_bytes_per_triangle = 128;

// Results.
/// A task's results are sent once they take so much, uncompressed.
inline constexpr std::size_t results_flush_bytes = 1u << 20;
/// Results are sent after so long at the latest.
inline constexpr std::chrono::milliseconds results_flush_period{50};
// Bounds on results that the master has not acknowledged. At either one the worker begins no
// further scenario.
inline constexpr std::uint64_t results_unkept_bytes_max = 64u << 20;
inline constexpr std::size_t results_unkept_messages_max = 1u << 14;
/// At the end of a drain, for the master to acknowledge the last results.
inline constexpr std::chrono::seconds results_kept_wait_max{5};

// Blocks.
/// Hints whose blocks are not fetched yet; with more, the oldest is dropped.
inline constexpr std::size_t hints_max = 1u << 16;
/// Blocks requested ahead of need at the same time, unpacked.
inline constexpr std::uint64_t hinted_bytes_max = 2u << 20;
/// Trees of an ended session stay cached so long in the next session, which may use them again.
inline constexpr std::chrono::minutes parked_trees_kept{10};

// Peers.
inline constexpr std::size_t peer_connections_max = 64; ///< From other workers.
/// Idle connections to other workers that are kept for reuse.
inline constexpr std::size_t peer_channels_kept_max = 16;
/// A peer that serves blocks has so long to send each message.
inline constexpr std::chrono::seconds peer_answer_max{5};
/// A peer's connection closes after so long without a request.
inline constexpr std::chrono::seconds peer_idle_max{60};

// Life of the process.
/// Longest pause after the first attempt.
inline constexpr std::chrono::milliseconds reconnect_after_min{100};
/// Longest pause after any attempt.
inline constexpr std::chrono::milliseconds reconnect_after_max{5000};
/// A drain's time by default: less than service managers allow.
inline constexpr std::chrono::seconds drain_timeout{25};
inline constexpr std::chrono::hours drain_timeout_max{24 * 7};
/// A worker that the master has accepted before retries for so long when TLS refuses the
/// connection.
inline constexpr std::chrono::hours refusal_retry_max{1};
/// A connection was short if it lasted less than so many times the tolerated silence.
inline constexpr int short_connection_silences = 4;

} // namespace cd::limits
