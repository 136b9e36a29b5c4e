// The points that two triangles share, where pairs of doubles can prove how they are rounded.
#pragma once

#include "common/geometry/double_double.hpp"
#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"

#include <array>
#include <optional>

namespace cd {

/// What `SharedPoints` promises, or nothing: for pairs that do not clearly cross, and where a
/// component is so near the middle between two doubles, or near 0, that its rounding is open.
class DoubleDoublePoints {
  public:
    explicit DoubleDoublePoints(const PosePair& poses);

    [[nodiscard]] std::optional<Vec3> origin(const Corners& a) const;
    /// The two ends of what triangles that properly cross share. Pairs with the same `a` one after
    /// the other share work.
    [[nodiscard]] std::optional<std::array<Vec3, 2>>
    points(const Corners& a, const Corners& b, const Vec3& origin);

    using Vector = std::array<DoubleDouble, 3>;

    /// A body's pose, and bounds on it.
    struct Map {
        std::array<Vector, 3> rows;
        Vec3 translation;
        double largest = 0; ///< Bounds each |entry| of the rows.
    };

    /// A triangle relative to an origin, with what is computed from it alone.
    struct Local {
        std::array<Vector, 3> corners;
        Vector normal;
        double magnitude = 0; ///< Bounds the terms that the coordinates were summed from.
        Vec3 least;           ///< Of the corners' high parts.
        Vec3 greatest;
        /// Of each corner, the components that are known to be 0 exactly. Edges and faces at right
        /// angles to an axis of an unrotated body often have them.
        std::array<std::array<bool, 3>, 3> is_zero{};
    };

  private:
    Map a_;
    Map b_;
    Corners last_a_;
    Vec3 last_origin_;
    std::optional<Local> local_a_; ///< Of last_a_ relative to last_origin_.
};

} // namespace cd
