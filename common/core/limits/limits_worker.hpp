// The bounds of a worker's process.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

inline constexpr std::chrono::seconds drain_timeout{25}; ///< Below the grace of what stops it.
inline constexpr std::chrono::hours drain_timeout_max{24 * 7};
/// A worker that was accepted before tries again for so long when TLS refuses its certificate.
inline constexpr std::chrono::hours refusal_retry_max{1};
/// A connection that lasted so many times the silence that was borne was a good one.
inline constexpr int short_connection_silences = 4;
inline constexpr std::size_t hints_max = 1u << 16; ///< Not asked for yet; then the oldest goes.
inline constexpr std::uint64_t hinted_bytes_max = 2u << 20; ///< Under way ahead of need, unpacked.

} // namespace cd::limits
