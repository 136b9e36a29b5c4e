// Periods, timeouts and lifetimes of a worker's process.
#pragma once

#include <chrono>

namespace cd::timing {

// Work.
/// A thread takes scenarios of a range for about this much work at a time.
inline constexpr double walk_seconds = 0.001;

// Results.
/// Results wait at most this long before they are sent.
inline constexpr std::chrono::milliseconds results_flush_period{50};
/// At the end of a drain, the worker waits this long for acknowledgements of its last results.
inline constexpr std::chrono::seconds results_kept_wait_max{5};

// Blocks.
/// Trees of an ended session stay cached this long in the next session, which can use them again.
inline constexpr std::chrono::minutes parked_trees_kept{10};

// Peers.
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

} // namespace cd::timing
