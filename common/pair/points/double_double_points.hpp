// The shared points of two triangles, where double-double can prove their rounding.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/pair_decision.hpp"
#include "common/pair/points/shared_corners.hpp"
#include "common/pair/stages/double_double/double_double_positions.hpp"

#include <array>
#include <functional>
#include <optional>
#include <span>

namespace cd {

/// Computes the origin and the points that `SharedPoints` promises, or nothing: a component may be
/// too close to 0 or to the middle between two doubles for its rounding to be proven, or two points
/// too close together for their order.
class DoubleDoublePoints {
  public:
    /// Multiplies all error bounds by `bound_scale`. Answers are right only from 1 on; tests use
    /// less to show that the bounds are needed.
    explicit DoubleDoublePoints(const PosePair& poses, double bound_scale = 1);
    DoubleDoublePoints(const DoubleDoublePoints&) = delete;
    DoubleDoublePoints& operator=(const DoubleDoublePoints&) = delete;

    /// Returns the first corner of A in the world, rounded; nothing if the rounding is unproven.
    [[nodiscard]] std::optional<Vec3> origin(const Corners& a) const;

    /// Selects the pair for the methods below. Consecutive pairs with the same `a` and origin share
    /// work. Returns false if the pair's numbers are out of range for these methods.
    [[nodiscard]] bool take(const Corners& a, const Corners& b, const Vec3& origin);

    /// Returns both ends of the shared segment, or nothing unless the pair provably crosses. Valid
    /// until the next call.
    [[nodiscard]] std::optional<std::span<const Vec3>> ends();

    /// The sides of A's corners against B's plane; `unknown_sign` where unproven.
    [[nodiscard]] const PlaneSides& sides_of_a() const { return half_a_.proven; }
    /// The sides of B's corners against A's plane; `unknown_sign` where unproven.
    [[nodiscard]] const PlaneSides& sides_of_b() const { return half_b_.proven; }

    /// Returns the points of `corners`, which must be all shared corners of the pair, in the order
    /// that `SharedPoints` promises; nothing if unproven. `offset` returns the exact first corner
    /// of A minus the origin, rounded; it is called only if `corners` has that corner. Valid until
    /// the next call.
    [[nodiscard]] std::optional<std::span<const Vec3>> at(const SharedCorners& corners,
                                                          const std::function<Vec3()>& offset);

  private:
    /// Returns component k of a corner of the current pair minus the origin, rounded once; nothing
    /// if that is unproven.
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
