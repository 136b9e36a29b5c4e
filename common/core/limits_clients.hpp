// The bounds of what peers may ask of the master, and tell it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

/// In one message: identities take a few bytes on the wire, and hundreds in memory.
inline constexpr std::uint64_t poses_part_scenarios_max = 1u << 16;

} // namespace cd::limits
