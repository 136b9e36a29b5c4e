// Periods, timeouts and lifetimes of the master.
#pragma once

#include <chrono>

namespace cd::timing {

// Connections.
inline constexpr std::chrono::hours client_idle_max{24};
/// A stopping master waits so long for its sessions and threads to end.
inline constexpr std::chrono::seconds stop_grace{5};

// Identity.
inline constexpr std::chrono::hours master_certificate_life{24 * 30};
/// Default validity of the certificates of workers and clients.
inline constexpr std::chrono::hours certificate_life{24 * 7};
inline constexpr std::chrono::seconds certificate_life_min{2};
inline constexpr std::chrono::hours token_life_max{24 * 30};
/// Period of the checks whether a connected certificate holder is refused meanwhile.
inline constexpr std::chrono::seconds holder_check_period{10};

// A client's share.
inline constexpr std::chrono::hours client_bytes_period{24};
/// A client above its share is told to retry after this.
inline constexpr std::chrono::seconds retry_after{30};

// Messages of clients, and answers to them.
/// Longest time between two messages of a client's submission.
inline constexpr std::chrono::seconds submission_idle_max{60};
/// Shortest time between two updates to a client that watches a job.
inline constexpr std::chrono::milliseconds watch_period{200};
/// A client waits so long until a cancellation is on the disk.
inline constexpr std::chrono::seconds cancel_wait_max{10};

// Jobs.
inline constexpr std::chrono::seconds retention_check_period{30};

// Results on their way to the journal.
inline constexpr std::chrono::milliseconds journal_group_period{5}; ///< Least time between commits.
/// Pause between two attempts while writes to the disk fail.
inline constexpr std::chrono::milliseconds journal_retry_period{500};

// Workers.
inline constexpr std::chrono::hours peer_lost_after_max{24};
inline constexpr std::chrono::milliseconds peer_check_period{500};
/// A worker is forgotten so long after its last message.
inline constexpr std::chrono::minutes worker_forgotten_after{10};
inline constexpr double scenario_seconds_shown = 10; ///< Status names scenarios that take longer.

// Delivery of blocks.
/// A fetch from a peer that takes longer has failed.
inline constexpr std::chrono::seconds peer_fetch_max{60};
/// A worker waits so long for a block from peers; then the master sends it.
inline constexpr std::chrono::seconds peer_wait_max{10};

// Dispatch.
/// Each worker above `workers_few` adds this to the period of checks.
inline constexpr double look_seconds_each = 2e-6;

// Matching by time: what is assumed until it is measured, and the size of batches.
inline constexpr double block_seconds = 20e-6; ///< Time to request a block and unpack it.
inline constexpr double batch_seconds_start = 0.1;
inline constexpr double batch_seconds_min = 0.001;
inline constexpr double batch_seconds_max = 1;
/// For scenarios that take longer, round trips do not matter.
inline constexpr double scenario_seconds_long = 0.05;

// The end of a job, when no work waits and some workers are idle.
inline constexpr double end_gain_seconds_min = 0.02; ///< A smaller gain is not worth the messages.
/// A recall that is not answered within this time counts as unanswered.
inline constexpr double recall_answer_seconds = 0.5;
inline constexpr std::chrono::milliseconds end_check_period{100}; ///< Period of straggler checks.

} // namespace cd::timing
