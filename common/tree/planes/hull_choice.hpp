// Chooses few of many points whose convex hull is close to the hull of all.
#pragma once

#include "common/geometry/types.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// A point in floats.
using FloatPoint = std::array<float, 3>;

/// Bounds distances from points to the convex hull of a growing set of points.
class HullDistance {
  public:
    /// Empties the set; `radius` bounds the distance of all later points from the origin.
    void clear(double radius);
    void add(const FloatPoint& point);
    [[nodiscard]] std::size_t size() const { return count_; }

    /// Returns an upper bound on the distance from a point to the hull, 0 only for points of the
    /// set: the distance to a convex combination of at most four points of the set, rounded up.
    /// Stops improving the bound below `enough`. Begins with the points of the last call, so calls
    /// for neighbours are fast. The set is not empty.
    [[nodiscard]] double bound(const FloatPoint& point, double enough);

  private:
    [[nodiscard]] Vec3 at(std::uint32_t number) const;

    std::vector<float> columns_; ///< As `SupportView::columns`, with room for `room_` points.
    std::uint32_t count_ = 0;
    std::uint32_t room_ = 0;
    double rounding_ = 0;
    std::vector<std::uint32_t> simplex_; ///< Numbers of up to four points.
};

/// Points that were chosen.
struct HullChoice {
    std::vector<std::uint32_t> numbers; ///< Indices of the chosen points.
    double eps =
        0; ///< Upper bound on the distance of every point from the hull of the chosen ones.
};

/// Chooses at most `count_max` points, at least 26: those farthest along the axes and diagonals,
/// then, again and again, the point that is farthest from the hull of those chosen before, until
/// none is farther than `eps_wanted`. `radius` bounds the distance of all points from the origin.
[[nodiscard]] HullChoice choose_hull(std::span<const FloatPoint> points,
                                     std::size_t count_max,
                                     double eps_wanted,
                                     double radius);

} // namespace cd
