// Cuts polygons into triangles.
#pragma once

#include "common/geometry/types.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Cuts one polygon after the other, and keeps its memory between them.
///
/// The polygon is judged in its projection along the axis that is nearest to its normal (Newell's),
/// by exact orientations: every triangle has the polygon's own orientation or no area. Such
/// triangles cover what the outline winds around, each place once if the outline does not cross
/// itself. Corners on a straight line give triangles without area, so that a polygon of n corners
/// always becomes n - 2 triangles.
///
/// A quadrilateral is cut from its concave corner, or else its first. Longer polygons lose one ear
/// after the other, beginning at the first corner; a convex one becomes a fan around its last.
class PolygonCutter {
  public:
    /// Positions in `corners` (four or more, finite), three a triangle. Valid until the next call.
    /// Empty when the outline crosses itself, or is too tangled to be cut in bounded time.
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
    std::uint64_t tests_ = 0; ///< Corners held against ears, of the polygon being cut.
};

} // namespace cd
