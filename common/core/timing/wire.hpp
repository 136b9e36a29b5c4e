// Periods, timeouts and lifetimes of connections and messages.
#pragma once

#include <chrono>

namespace cd::timing {

// Contents that proto/ checks.
/// Longest computing time that a message of results may state, so that sums stay finite.
inline constexpr double compute_seconds_max = 1e7;
/// Longest time for which a work unit may let results wait.
inline constexpr std::chrono::milliseconds results_wait_max{10'000};

// TLS and certificates.
/// Validity of the cluster's own CA certificate.
inline constexpr std::chrono::hours authority_life{24 * 3650};
inline constexpr std::chrono::minutes clock_difference_max{5}; ///< Tolerated between two hosts.
/// Longest time between two checks of whether a certificate needs renewal.
inline constexpr std::chrono::minutes renewal_check_period{1};
inline constexpr std::chrono::seconds renewal_retry_min{1}; ///< Least pause between renewals.

// Log lines about refused connections.
inline constexpr std::chrono::seconds refusal_log_period{1};

// Silence and stalls.
inline constexpr std::chrono::seconds heartbeat_period{2};
inline constexpr std::chrono::milliseconds heartbeat_period_min{10};
/// After a worker's silence of this length, the master gives its work to other workers.
inline constexpr std::chrono::seconds peer_lost_after{15};
inline constexpr std::chrono::seconds connect_timeout{10};
/// The connection closes if a frame cannot be sent within this time.
inline constexpr std::chrono::seconds write_stall_max{30};
/// The connection closes if the next frame of a begun message does not arrive within this time.
inline constexpr std::chrono::seconds read_stall_max{30};
/// A closing connection may spend this long on sending its queued messages.
inline constexpr std::chrono::seconds close_flush_max{5};
/// Pause after a failed accept, for example for lack of file descriptors.
inline constexpr std::chrono::milliseconds accept_retry_period{100};
/// Once a deadline has passed, outstanding operations are cancelled again in this period.
inline constexpr std::chrono::milliseconds overdue_check_period{50};

// HTTP.
inline constexpr std::chrono::seconds http_exchange_max{10}; ///< Time for a request and its answer.

// Workers that fetch blocks from each other.
/// A worker that cannot connect to a source within this time tries the next source.
inline constexpr std::chrono::seconds peer_connect_timeout{2};

} // namespace cd::timing
