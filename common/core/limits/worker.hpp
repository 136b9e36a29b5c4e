// Bounds of a worker's process.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

// Work.
inline constexpr std::size_t jobs_per_thread_max = 4;  ///< Begun or queued for the threads.
inline constexpr double walk_seconds = 0.001;          ///< One thread's turn at a range.
inline constexpr std::size_t walk_scenarios_max = 256; ///< In one turn.
/// Scenarios that wait for subtrees; with more, the worker descends into no further scenario.
inline constexpr std::size_t walked_waiting_max = 4096;
inline constexpr std::uint64_t binary_bytes_per_triangle = 128; ///< Binary subtrees in memory.

// Results.
inline constexpr std::size_t results_flush_bytes = 1u << 20; ///< Of one task, uncompressed.
inline constexpr std::chrono::milliseconds results_flush_period{50};
// Bounds on unacknowledged results; above either one the worker begins no further task.
inline constexpr std::uint64_t results_unkept_bytes_max = 64u << 20;
inline constexpr std::size_t results_unkept_messages_max = 1u << 14;
inline constexpr std::chrono::seconds results_kept_wait_max{
    5}; ///< For acknowledgements, at a drain.

// Blocks.
inline constexpr std::size_t hints_max = 1u << 16; ///< Not yet fetched; then the oldest is dropped.
inline constexpr std::uint64_t hinted_bytes_max = 2u << 20;  ///< Fetched ahead of need, unpacked.
inline constexpr std::chrono::minutes parked_trees_kept{10}; ///< Unused, after their session ended.

// Peers.
inline constexpr std::size_t peer_connections_max = 64;   ///< From other workers; more wait.
inline constexpr std::size_t peer_channels_kept_max = 16; ///< To other workers, for reuse.
inline constexpr std::chrono::seconds peer_answer_max{5}; ///< Between two messages of a peer.
inline constexpr std::chrono::seconds peer_idle_max{60};  ///< An unused connection of a peer.

// Life of the process.
inline constexpr std::chrono::milliseconds reconnect_after_min{100};
inline constexpr std::chrono::milliseconds reconnect_after_max{5000};
inline constexpr std::chrono::seconds drain_timeout{25}; ///< Below what service managers allow.
inline constexpr std::chrono::hours drain_timeout_max{24 * 7};
/// A worker that was welcome before retries for so long when TLS refuses it.
inline constexpr std::chrono::hours refusal_retry_max{1};
/// A connection counts as good if it lasted so many times the tolerated silence.
inline constexpr int short_connection_silences = 4;

} // namespace cd::limits
