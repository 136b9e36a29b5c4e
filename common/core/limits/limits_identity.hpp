// The bounds of what strangers and those of each role may have of a program.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

/// What is begun after a deadline ends this long after it, at the most.
inline constexpr std::chrono::milliseconds overdue_check_period{50};

inline constexpr std::uint64_t greeting_bytes_max = 4u << 10; ///< Whatever comes first.
inline constexpr std::uint64_t join_bytes_max = 64u << 10;    ///< With a request's PEM.
inline constexpr std::uint64_t observer_bytes_max = 4u << 10; ///< Questions without a content.
inline constexpr std::size_t streams_small_max = 1;           ///< Of a peer with small messages;
inline constexpr std::size_t streams_of_lanes_max = 2;        ///< of all others, one a lane.

inline constexpr std::chrono::seconds refusal_log_period{1}; ///< Of lines about one host.
inline constexpr std::size_t refusal_lines_max = 8;          ///< In that time; then it is counted.
inline constexpr std::size_t refusal_hosts_max = 1024;       ///< Remembered for that.

} // namespace cd::limits
