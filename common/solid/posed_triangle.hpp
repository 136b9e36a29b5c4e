// A triangle of one body in the coordinates of another: rounded with bounds, and exact on demand.
#pragma once

#include "common/geometry/types.hpp"
#include "common/solid/exact_frame.hpp"
#include "common/solid/point_in_solid.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace cd {

/// A triangle of the inner body in the outer body's coordinates. All answers are exact. The frame
/// outlives this object and has an inverse.
class PosedTriangle {
  public:
    PosedTriangle(const ExactFrame& frame,
                  const RelativePose& inner_to_outer,
                  const Corners& corners);
    PosedTriangle(const PosedTriangle&) =
        delete; // Not copyable: `centroid()` refers to this object.
    PosedTriangle& operator=(const PosedTriangle&) = delete;

    /// Returns true when the corners lie on one line. `exact_corners`, `centroid` and `drop` work
    /// then, too; all other members require a triangle with area.
    [[nodiscard]] bool is_flat() const { return drop_ == 3; }

    /// Returns the side of this triangle's plane on which a point of the outer body lies, as a
    /// sign.
    [[nodiscard]] int plane_side(const Vec3& point);

    /// Returns on which side of the edge from corner k a point of the outer body in this triangle's
    /// plane lies: 1 on the triangle's side, 0 on the edge's line, -1 beyond. For a point off the
    /// plane the answer is that of its projection.
    [[nodiscard]] int edge_side(std::size_t k, const Vec3& point);
    /// Returns `edge_side` if doubles prove it, else nothing.
    [[nodiscard]] std::optional<int> proven_edge_side(std::size_t k, const Vec3& point) const;

    /// Returns on which side of a line corner k lies. `from` and `to` are points of the outer body
    /// in this triangle's plane. The sign changes with the line's direction, and is 0 on the line.
    [[nodiscard]] int line_side(const Vec3& from, const Vec3& to, std::size_t k);

    /// Returns 1 if a triangle of the outer body in this triangle's plane has the same winding, -1
    /// if the opposite winding, and 0 if it has no area.
    [[nodiscard]] int winding(const Corners& coplanar) const;

    /// Returns the sign of the dot product of a direction in the outer body's coordinates with the
    /// normal. The normal points to where `plane_side` is negative.
    [[nodiscard]] int forward(const Vec3& direction);
    /// Returns `plane_side` if doubles prove it, else nothing.
    [[nodiscard]] std::optional<int> proven_plane_side(const Vec3& point) const;

    [[nodiscard]] SolidPoint centroid();

    /// Returns the corners in the exact frame.
    [[nodiscard]] const std::array<DyadicVec, 3>& exact_corners();
    /// Returns the axis along which the plane may be projected; 3 for a flat triangle.
    [[nodiscard]] std::size_t drop() const { return drop_; }

  private:
    [[nodiscard]] DyadicVec exact_normal();
    void choose_projection();
    /// Returns true if `rounded_` are the exact corners, so that doubles may decide what their
    /// error bounds leave open.
    [[nodiscard]] bool is_rounding_exact();

    const ExactFrame& frame_;
    Corners inner_;
    Corners rounded_;
    double error_ = 0; ///< Bound on the error of each component of `rounded_`.
    std::size_t drop_ = 3;
    int orientation_ = 0; ///< Sign of the normal's component `drop`.
    std::optional<std::array<DyadicVec, 3>> exact_;
    std::optional<DyadicVec> exact_normal_;
    std::optional<bool> is_rounding_exact_;
};

} // namespace cd
