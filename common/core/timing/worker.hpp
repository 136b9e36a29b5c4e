// Periods, timeouts and lifetimes of a worker's process.
#pragma once

#include <chrono>

namespace cd::timing {

// Work.
/// A thread takes as many scenarios of a range at a time as make about this much work.
inline constexpr double walk_seconds = 0.001;

// Results.
/// While a thread of the worker is idle, results wait at most this long, whatever the master
/// allows.
inline constexpr std::chrono::milliseconds results_wait_idle{50};
/// Arrived blocks are reported after this part of the time for which results may wait. It is short,
/// since other workers wait for these blocks.
inline constexpr int held_waits_per_results_wait = 20;
/// At the end of a drain, the worker waits this long for acknowledgements of its last results.
inline constexpr std::chrono::seconds results_kept_wait_max{5};

// Peers.
/// A peer that serves blocks must send each message within this time.
inline constexpr std::chrono::seconds peer_stall_max{5};
/// A peer's connection closes after this time without a request.
inline constexpr std::chrono::seconds peer_idle_max{60};

// The process: connecting and draining.
/// Longest pause after the first attempt to connect; the bound doubles with each attempt.
inline constexpr std::chrono::milliseconds reconnect_pause_first{100};
/// Longest pause after any attempt to connect.
inline constexpr std::chrono::milliseconds reconnect_pause_max{5000};
/// Default time limit of a drain, shorter than the stop timeouts of service managers.
inline constexpr std::chrono::seconds drain_timeout{25};
inline constexpr std::chrono::hours drain_timeout_max{24 * 7};
/// A worker that a master has accepted before retries for this long after a TLS refusal.
inline constexpr std::chrono::hours refusal_retry_max{1};

/// A worker checks this often whether --idle-exit or --orphan-exit applies.
inline constexpr std::chrono::milliseconds leave_check_period{250};

} // namespace cd::timing
