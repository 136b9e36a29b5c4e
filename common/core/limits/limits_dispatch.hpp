// The bounds of what one event costs the dispatcher.
#pragma once

#include <cstddef>

namespace cd::limits {

/// In a larger cluster, to look at all workers after each event would be all that the master does.
inline constexpr std::size_t workers_few = 64;
inline constexpr double look_seconds_each = 2e-6;
/// At a job's end so many late workers are looked at together, or this part of all workers.
inline constexpr std::size_t late_looked_at_min = 64;
inline constexpr std::size_t late_looked_at_part = 16;
inline constexpr std::size_t sources_looked_at_max = 64; ///< For one block that somebody wants.
inline constexpr std::size_t helpers_tried_max = 4;      ///< For each of these.

} // namespace cd::limits
