// The points that two triangles share, where pairs of doubles can prove how they are rounded.
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

/// What `SharedPoints` promises, or nothing: where a component is so near the middle between two
/// doubles, or near 0, that its rounding is open, or two points are too near each other.
class DoubleDoublePoints {
  public:
    /// All error bounds are multiplied by `bound_scale`. Only from 1 on is an answer right: less is
    /// for tests, which show that the bounds are needed.
    explicit DoubleDoublePoints(const PosePair& poses, double bound_scale = 1);
    DoubleDoublePoints(const DoubleDoublePoints&) = delete;
    DoubleDoublePoints& operator=(const DoubleDoublePoints&) = delete;

    [[nodiscard]] std::optional<Vec3> origin(const Corners& a) const;

    /// Takes up a pair: what follows is about it. Pairs with the same `a` and origin one after the
    /// other share work. False when its numbers are out of range for all that follows.
    [[nodiscard]] bool take(const Corners& a, const Corners& b, const Vec3& origin);

    /// The two ends of what the pair shares, if it clearly crosses. Valid until the next call.
    [[nodiscard]] std::optional<std::span<const Vec3>> ends();

    /// The signs of a triangle's corners against the other's plane, as far as they are proven.
    [[nodiscard]] const PlaneSides& sides_of_a() const { return half_a_.proven; }
    [[nodiscard]] const PlaneSides& sides_of_b() const { return half_b_.proven; }

    /// The points that these corners are, in order, if they are what the pair shares. `offset`
    /// gives the exact first corner of A minus the origin, rounded; it is asked only if that is one
    /// of them. Valid until the next call.
    [[nodiscard]] std::optional<std::span<const Vec3>> at(const SharedCorners& corners,
                                                          const std::function<Vec3()>& offset);

  private:
    /// Of a corner of the pair at hand, relative to the origin, where nothing else rounds it.
    [[nodiscard]] std::optional<double> nearest_of_corner(
        const DoubleDoubleVec* corner, std::size_t k, const std::function<Vec3()>& offset) const;

    LocalMap a_;
    LocalMap b_;
    double scale_;
    Corners last_a_;
    Corners last_b_;
    Vec3 origin_;
    std::optional<LocalTriangle> local_a_; ///< Of last_a_ relative to origin_.
    std::optional<LocalTriangle> local_b_;
    LocalBounds bounds_;
    LocalHalf half_a_;
    LocalHalf half_b_;
    std::array<Vec3, 6> points_; ///< What was last found.
};

} // namespace cd
