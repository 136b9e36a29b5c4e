// Finds the pairs of boxes that overlap: the broad phase of a scene of many bodies.
#pragma once

#include "common/scene/world_box.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Two bodies by their indices, a < b.
struct BodyPair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;

    friend auto operator<=>(const BodyPair&, const BodyPair&) = default;
};

inline constexpr std::size_t boxes_max = 1u << 16; ///< Of a sweep.

/// Returns all pairs of boxes that share a point, sorted, but for those of two fixed boxes. At most
/// `boxes_max` boxes. `is_fixed` says of each box whether it is fixed; if empty, none is.
///
/// Sorts the boxes by their low ends on the axis where the fewest overlap, as a sample tells, and
/// compares each with those that begin before it ends (Baraff, Dynamic simulation of
/// non-penetrating rigid bodies, 1992, section 3.3.2). Where each box meets many others so, it does
/// this in strips of a second axis. If few boxes move, only these are compared with all. It keeps
/// nothing from earlier calls. The time is O(n log n) and the number of pairs that overlap on the
/// first axis in one strip.
[[nodiscard]] std::vector<BodyPair> overlapping_pairs(std::span<const WorldBox> boxes,
                                                      std::span<const std::uint8_t> is_fixed = {});

} // namespace cd
