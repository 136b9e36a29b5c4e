// Fits an oriented box to triangles (paper, 6.1).
#pragma once

#include "common/geometry/types.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// A triangle on its way to its place in the tree.
struct BuildTriangle {
    Triangle vertices{};
    std::uint32_t id = 0; ///< Its place in the mesh.
};

struct Interval {
    double low = 0;
    double high = 0;
};

/// Where triangles lie on the three axes of a frame, as seen from `origin`. Rounded.
struct Projections {
    Vec3 origin = Vec3::Zero();
    std::array<std::vector<Interval>, 3> triangles; ///< For each axis, one interval per triangle.
    std::array<Interval, 3> whole;                  ///< Of all triangles together.
};

/// The rows of `axes` are a body's own three directions, exactly.
inline constexpr std::array<float, 9> body_axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/// The frame of the Gaussian distribution fitted to the corners of the triangles: the eigenvectors
/// of their covariance, narrowest direction first. The rows are orthonormal within
/// `axes_error_max`. Where numbers overflow, the body's own axes.
[[nodiscard]] std::array<float, 9> fit_axes(std::span<const BuildTriangle> triangles,
                                            std::span<const Vec3> vertices);

/// Bounds each |entry| of F F' - I for the frame F of every node.
inline constexpr double axes_error_max = 0x1p-23;

/// Coordinates below this in size can be measured: nothing below overflows.
inline constexpr double coordinate_max = 0x1p1000;

/// The box of a node with coordinates beyond that: all of space.
void set_unbounded_box(ObbNode& node);

/// Fills `out`, whose memory is used again.
void project(std::span<const BuildTriangle> triangles,
             std::span<const Vec3> vertices,
             const std::array<float, 9>& axes,
             Projections& out);

/// Sets `center` and `half` of a node with these axes so that all vertices projected lie inside, in
/// exact terms.
void set_box(const Projections& projections, ObbNode& node);

} // namespace cd
