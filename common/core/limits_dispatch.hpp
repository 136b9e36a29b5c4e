// The bounds of what one event costs the dispatcher.
#pragma once

#include <cstddef>

namespace cd::limits {

/// At a job's end: between two looks for workers that others could help, for each worker here.
inline constexpr double help_seconds_each = 2e-6;
/// So many of these are looked at together, or this part of all workers.
inline constexpr std::size_t late_looked_at_min = 64;
inline constexpr std::size_t late_looked_at_part = 16;
inline constexpr std::size_t helpers_tried_max = 4; ///< For each of these.

} // namespace cd::limits
