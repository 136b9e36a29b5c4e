// A triangle of one body as another body sees it: rounded with bounds, and
// exactly if need be.
#pragma once

#include "common/geometry/types.hpp"
#include "common/solid/exact_frame.hpp"
#include "common/solid/point_in_solid.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace cd {

/// A triangle of the inner body in coordinates of the outer one. All answers
/// are exact. The frame outlives it and has an inverse.
class PosedTriangle {
  public:
    PosedTriangle(const ExactFrame& frame,
                  const RelativePose& inner_to_outer,
                  const Corners& corners);
    PosedTriangle(const PosedTriangle&) = delete; // Its centroid refers to it.
    PosedTriangle& operator=(const PosedTriangle&) = delete;

    /// True when the corners lie on one line. What follows but for the centroid
    /// is only for triangles with area.
    [[nodiscard]] bool is_flat() const { return drop_ == 3; }

    /// The sign of the side of this triangle's plane on which a point of the
    /// outer body lies.
    [[nodiscard]] int plane_side(const Vec3& point);

    /// Which side of the edge from corner k a point of the outer body in this
    /// triangle's plane lies on: 1 on the triangle's, 0 on its line, -1 beyond.
    /// Of another point, that of a projection.
    [[nodiscard]] int edge_side(std::size_t k, const Vec3& point);
    /// The same where doubles tell.
    [[nodiscard]] std::optional<int> proven_edge_side(std::size_t k, const Vec3& point) const;

    /// Which side of the line from one point of the outer body in this triangle's plane to another
    /// corner k lies on: the sign changes with the direction, and is 0 on the line.
    [[nodiscard]] int line_side(const Vec3& from, const Vec3& to, std::size_t k);

    /// 1 if a triangle of the outer body in the same plane is wound the same way,
    /// -1 if not.
    [[nodiscard]] int winding(const Corners& coplanar) const;

    /// The sign of the product of a direction in the outer body's coordinates with the normal,
    /// towards which `plane_side` is below 0.
    [[nodiscard]] int forward(const Vec3& direction);
    /// `plane_side` where doubles tell.
    [[nodiscard]] std::optional<int> proven_plane_side(const Vec3& point) const;

    [[nodiscard]] SolidPoint centroid();

    /// The corners in the exact frame.
    [[nodiscard]] const std::array<DyadicVec, 3>& exact_corners();
    /// The axis along which the plane may be projected; 3 for a flat triangle.
    [[nodiscard]] std::size_t drop() const { return drop_; }

  private:
    [[nodiscard]] DyadicVec exact_normal();
    void choose_projection();
    /// Whether the corners are doubles, so that doubles may decide what filters
    /// leave open.
    [[nodiscard]] bool is_rounding_exact();

    const ExactFrame& frame_;
    Corners inner_;
    Corners rounded_;
    double error_ = 0; ///< Of each component of `rounded_`.
    std::size_t drop_ = 3;
    int orientation_ = 0; ///< The sign of that component of the normal.
    std::optional<std::array<DyadicVec, 3>> exact_;
    std::optional<DyadicVec> exact_normal_;
    std::optional<bool> is_rounding_exact_;
};

} // namespace cd
