// The shared points of two triangles, where double-double can prove their rounding.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/pair_decision.hpp"
#include "common/pair/points/shared_corners.hpp"
#include "common/pair/stages/double_double/double_double_places.hpp"

#include <array>
#include <functional>
#include <optional>
#include <span>

namespace cd {

/// Gives what `SharedPoints` promises, or nothing: a component may be too close to 0 or to the
/// middle between two doubles for its rounding to be proven, or two points too close together.
class DoubleDoublePoints {
  public:
    /// Multiplies all error bounds by `bound_scale`. Answers are right only from 1 on; tests use
    /// less to show that the bounds are needed.
    explicit DoubleDoublePoints(const PosePair& poses, double bound_scale = 1);
    DoubleDoublePoints(const DoubleDoublePoints&) = delete;
    DoubleDoublePoints& operator=(const DoubleDoublePoints&) = delete;

    [[nodiscard]] std::optional<Vec3> origin(const Corners& a) const;

    /// Selects the pair for the methods below. Consecutive pairs with the same `a` and origin share
    /// work. Returns false if the pair's numbers are out of range for these methods.
    [[nodiscard]] bool take(const Corners& a, const Corners& b, const Vec3& origin);

    /// Returns both ends of the shared segment if the pair provably crosses. Valid until the next
    /// call.
    [[nodiscard]] std::optional<std::span<const Vec3>> ends();

    /// The proven signs of a triangle's corners against the other's plane.
    [[nodiscard]] const PlaneSides& sides_of_a() const { return half_a_.proven; }
    [[nodiscard]] const PlaneSides& sides_of_b() const { return half_b_.proven; }

    /// Computes the points of `corners`, ordered; they must be what the pair shares. `offset` gives
    /// the exact first corner of A minus the origin, rounded; it is called only if that corner is
    /// among them. Valid until the next call.
    [[nodiscard]] std::optional<std::span<const Vec3>> at(const SharedCorners& corners,
                                                          const std::function<Vec3()>& offset);

  private:
    /// Rounds component k of a corner of the current pair, relative to the origin, once.
    [[nodiscard]] std::optional<double> nearest_of_corner(
        const DoubleDoubleVec* corner, std::size_t k, const std::function<Vec3()>& offset) const;

    LocalMap a_;
    LocalMap b_;
    double scale_;
    Corners last_a_;
    Corners last_b_;
    Vec3 origin_;
    std::optional<LocalTriangle> local_a_; ///< `last_a_` relative to `origin_`.
    std::optional<LocalTriangle> local_b_;
    LocalBounds bounds_;
    LocalHalf half_a_;
    LocalHalf half_b_;
    std::array<Vec3, 6> points_; ///< The points found last.
};

} // namespace cd
