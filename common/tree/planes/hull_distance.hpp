// Distances to the convex hull of few points.
#pragma once

#include "common/geometry/types.hpp"
#include "common/tree/planes/float_point.hpp"

#include <cstdint>
#include <vector>

namespace cd {

/// Bounds distances from points to the convex hull of a growing set of points.
class HullDistance {
  public:
    /// The set is empty; `radius` bounds the distance of all later points from the origin.
    explicit HullDistance(double radius) : radius_(radius) {}

    void add(const FloatPoint& point);

    /// Returns an upper bound on the distance from a point to the hull: the `distance_bound` of at
    /// most four points of the set (Gilbert, Johnson, Keerthi, IEEE J. Robotics Autom. 4(2), 1988).
    /// Stops improving the bound below `enough`. Begins with the points of the last call, so calls
    /// for neighbours are fast. The set is not empty.
    [[nodiscard]] double bound(const FloatPoint& point, double enough);

  private:
    [[nodiscard]] Vec3 at(std::uint32_t number) const;

    std::vector<float> columns_; ///< As `SupportView::columns`, with room for `room_` points.
    std::uint32_t count_ = 0;
    std::uint32_t room_ = 0;
    double radius_;
    std::vector<std::uint32_t> simplex_; ///< Numbers of up to four points.
};

} // namespace cd
