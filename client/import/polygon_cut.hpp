// Cuts polygons into triangles.
#pragma once

#include "common/geometry/types.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Cuts polygons one after another, and reuses memory between them.
///
/// The polygon is projected along the axis nearest to its Newell normal, and orientations in the
/// projection are exact: every triangle has the polygon's orientation or no area. The triangles
/// cover the inside of the outline, each point once if the outline does not cross itself. Collinear
/// corners give triangles without area, so a polygon of n corners always gives n - 2 triangles.
///
/// A quadrilateral is cut from its concave corner, or its first if it is convex. Longer polygons
/// lose ears from the first corner on; a convex one becomes a fan around its last corner.
class PolygonCutter {
  public:
    /// Returns indices into `corners`, four or more finite points; they are valid until the next
    /// call. Returns none if the outline crosses itself or cannot be cut in bounded time.
    [[nodiscard]] std::span<const Triangle> cut(std::span<const Vec3> corners);

  private:
    using Point = std::array<double, 2>;

    void project(std::span<const Vec3> corners);
    [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
    void try_quad(std::uint32_t start);
    void cut_quad(std::span<const Vec3> corners);
    void cut_ears();
    [[nodiscard]] bool is_ear(std::uint32_t corner);
    [[nodiscard]] bool contains(const Triangle& ear, std::uint32_t corner) const;
    void classify(std::uint32_t corner);
    void unlink(std::uint32_t corner);
    void add_last(std::uint32_t corner);

    std::vector<Point> points_;
    std::vector<std::uint32_t> next_;
    std::vector<std::uint32_t> previous_;
    std::vector<std::uint8_t> is_convex_;
    std::vector<Triangle> triangles_;
    std::uint64_t tests_ = 0; ///< Corners tested against ears of the current polygon.
};

} // namespace cd
