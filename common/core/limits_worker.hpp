// The bounds of a worker's process.
#pragma once

#include <chrono>

namespace cd::limits {

inline constexpr std::chrono::seconds drain_timeout{25}; ///< Below the grace of what stops it.
inline constexpr std::chrono::hours drain_timeout_max{24 * 7};

} // namespace cd::limits
