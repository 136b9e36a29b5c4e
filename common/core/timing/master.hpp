// Periods, timeouts and lifetimes of the master.
#pragma once

#include <chrono>

namespace cd::timing {

// Connections.
inline constexpr std::chrono::hours client_idle_max{24};
/// A stopping master waits this long for its sessions and threads to end.
inline constexpr std::chrono::seconds stop_grace{5};

// Identity.
inline constexpr std::chrono::hours master_certificate_life{24 * 30};
/// Default validity of the certificates of workers and clients.
inline constexpr std::chrono::hours certificate_life{24 * 7};
inline constexpr std::chrono::seconds certificate_life_min{2};
inline constexpr std::chrono::hours token_life_max{24 * 30};
/// Period in which a session checks whether its certificate's holder has been refused meanwhile.
inline constexpr std::chrono::seconds holder_check_period{10};

// A client's share.
inline constexpr std::chrono::hours client_bytes_period{24};
/// The master tells a client above its share to retry after this time.
inline constexpr std::chrono::seconds retry_after{30};

// Messages of clients, and answers to them.
/// Longest time between two messages of a client's submission. Between two, a client may make
/// `limits::order_window_scenarios` random poses, which takes a slow host minutes.
inline constexpr std::chrono::minutes submission_idle_max{10};
/// Shortest time between two updates to a client that watches a job.
inline constexpr std::chrono::milliseconds watch_period{200};
/// Longest time that the master delays its answer until a cancellation is on the disk.
inline constexpr std::chrono::seconds cancel_wait_max{10};
/// Longest search of one scenario to explain what it takes.
inline constexpr std::chrono::seconds explained_search_max{5};

// Jobs.
inline constexpr std::chrono::seconds retention_check_period{30};

// Results on their way to the journal.
inline constexpr std::chrono::milliseconds journal_commit_period{
    5}; ///< Least time between commits.
/// Pause between two attempts while writes to the disk fail.
inline constexpr std::chrono::milliseconds journal_retry_period{500};

// Workers.
inline constexpr std::chrono::hours peer_lost_after_max{24};
inline constexpr std::chrono::milliseconds peer_check_period{500};
/// Time from a lost worker's last message until the master forgets the worker.
inline constexpr std::chrono::minutes worker_forgotten_after{10};
inline constexpr double scenario_seconds_shown = 10; ///< Status names scenarios that take longer.

// Delivery of blocks.
/// A worker's fetch of blocks from a peer counts as failed after this time.
inline constexpr std::chrono::seconds peer_fetch_max{60};
/// The master sends a block itself if a worker has waited this long for it, and no other worker
/// has received it in this time.
inline constexpr std::chrono::seconds peer_wait_max{10};

// Dispatch.
/// Each worker above `limits::workers_few` adds this to the period of checks of all workers, s.
inline constexpr double look_seconds_each = 20e-6;

// Shares of owners and jobs.
/// An owner that does not use its share saves up so much time of all threads at most, s.
inline constexpr double share_credit_seconds = 10;
/// A job's share of the threads is shown over about this time, s.
inline constexpr double share_shown_seconds = 10;

// Messages of workers. The master bounds how many come per second, whatever the number of workers.
/// Results of a task may wait this long at a worker, and longer if there are many workers.
inline constexpr double results_wait_seconds_min = 0.05;
/// Each worker adds this to the time between two messages of results of a worker, and to the length
/// of ranges: 5,000 messages/s.
inline constexpr double message_seconds_each = 2e-4;
inline constexpr double message_seconds_max = 1; ///< Longest such time.

// Matching by time: values assumed until they are measured, and the size of batches.
inline constexpr double block_seconds = 20e-6; ///< Time to request and unpack a block.
inline constexpr double batch_seconds_start = 0.1;
inline constexpr double batch_seconds_min = 0.001;
inline constexpr double batch_seconds_max = 1;
/// Scenarios that take longer on average are long: a round trip per scenario does not matter.
inline constexpr double scenario_seconds_long = 0.05;

// The end of a job, when no work waits and some workers are idle.
inline constexpr double end_gain_seconds_min = 0.02; ///< Smallest gain that is worth the messages.
/// After this time without an answer, a recall no longer counts as pending.
inline constexpr double recall_answer_seconds = 0.5;
/// Period of checks for stragglers, and for positions that wait while no event comes.
inline constexpr std::chrono::milliseconds end_check_period{100};

} // namespace cd::timing
