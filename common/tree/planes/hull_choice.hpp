// Chooses few of many points whose convex hull is close to the hull of all.
#pragma once

#include "common/tree/planes/float_point.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Points that were chosen.
struct HullChoice {
    std::vector<std::uint32_t> numbers; ///< Indices of the chosen points.
    double eps =
        0; ///< Upper bound on the distance of every point from the hull of the chosen ones.
};

/// Chooses at most `count_max` points, at least 4: again and again the one that is farthest outside
/// the hull of those chosen before, until none is farther than `eps_wanted`. `radius` bounds the
/// distance of all points from the origin; at least one point.
[[nodiscard]] HullChoice choose_hull(std::span<const FloatPoint> points,
                                     std::size_t count_max,
                                     double eps_wanted,
                                     double radius);

} // namespace cd
