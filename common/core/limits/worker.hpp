// Bounds of a worker's process.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

// Work.
inline constexpr std::size_t jobs_per_thread_max = 4; ///< Scenarios and descents begun or queued.
/// A thread takes scenarios of a range for about this much work at a time.
inline constexpr double walk_seconds = 0.001;
inline constexpr std::size_t walk_scenarios_max = 256; ///< Scenarios of a range taken at a time.
/// Number of scenarios that wait for subtrees. With more, the worker begins no further descent of
/// the upper trees.
inline constexpr std::size_t walked_waiting_max = 4096;
/// Estimated memory of a binary subtree.
inline constexpr std::uint64_t binary_bytes_per_triangle = 128;

// Results.
/// A task's results are sent once their uncompressed size reaches this.
inline constexpr std::size_t results_flush_bytes = 1u << 20;
/// Results wait at most this long before they are sent.
inline constexpr std::chrono::milliseconds results_flush_period{50};
// Bounds on results that the master has not acknowledged. At either one the worker begins no
// further scenario.
inline constexpr std::uint64_t results_unkept_bytes_max = 64u << 20;
inline constexpr std::size_t results_unkept_messages_max = 1u << 14;
/// At the end of a drain, the worker waits this long for acknowledgements of its last results.
inline constexpr std::chrono::seconds results_kept_wait_max{5};

// Blocks.
/// Number of hints whose blocks are not fetched yet; with more, the oldest is dropped.
inline constexpr std::size_t hints_max = 1u << 16;
/// Unpacked size of the blocks that are being requested ahead of need.
inline constexpr std::uint64_t hinted_bytes_max = 2u << 20;
/// Trees of an ended session stay cached this long in the next session, which can use them again.
inline constexpr std::chrono::minutes parked_trees_kept{10};

// Peers.
inline constexpr std::size_t peer_connections_max = 64; ///< Connections from other workers.
/// Idle connections to other workers that are kept for reuse.
inline constexpr std::size_t peer_channels_kept_max = 16;
/// A peer that serves blocks must send each message within this time.
inline constexpr std::chrono::seconds peer_answer_max{5};
/// A peer's connection closes after this time without a request.
inline constexpr std::chrono::seconds peer_idle_max{60};

// Life of the process.
/// Longest pause after the first attempt.
inline constexpr std::chrono::milliseconds reconnect_after_min{100};
/// Longest pause after any attempt.
inline constexpr std::chrono::milliseconds reconnect_after_max{5000};
/// Default time limit of a drain, shorter than service managers allow.
inline constexpr std::chrono::seconds drain_timeout{25};
inline constexpr std::chrono::hours drain_timeout_max{24 * 7};
/// A worker that the master has accepted before retries for this long when TLS refuses the
/// connection.
inline constexpr std::chrono::hours refusal_retry_max{1};
/// A connection counts as short if it lasted less than this many times the tolerated silence.
inline constexpr int short_connection_silences = 4;

} // namespace cd::limits
