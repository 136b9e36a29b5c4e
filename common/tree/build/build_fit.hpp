// Fits an oriented box to triangles (paper, 6.1).
#pragma once

#include "common/geometry/types.hpp"
#include "common/tree/build/build_eigen.hpp"
#include "common/tree/obb_tree.hpp"

#include <array>
#include <cstddef>
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

/// Where a triangle or all of a node lies on the three axes of a frame, as seen from an origin.
/// Rounded.
using Projection = std::array<Interval, 3>;

/// The rows of `axes` are a body's own three directions, exactly.
inline constexpr std::array<float, 9> body_axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/// Sums over the corners of triangles, as seen from an origin. A vertex counts once for each
/// triangle that uses it, as in Eberly, 3D Game Engine Design (2001), fitting points with a
/// Gaussian.
struct Moments {
    Vec3 sum = Vec3::Zero();
    SymmetricMatrix products{};
    std::size_t corners = 0;

    Moments& operator+=(const Moments& other);
};

/// One after the other: the same triangles in the same order give the same bits.
[[nodiscard]] Moments sum_moments(std::span<const BuildTriangle> triangles,
                                  std::span<const Vec3> vertices,
                                  const Vec3& origin);

/// The frames of the Gaussian distributions fitted to the corners of some nodes: the eigenvectors
/// of their covariances, narrowest direction first. The rows are orthonormal within
/// `axes_error_max`. Where numbers overflow, the body's own axes.
[[nodiscard]] std::vector<std::array<float, 9>> fit_axes(std::span<const Moments> nodes);

/// Bounds each |entry| of F F' - I for the frame F of every node.
inline constexpr double axes_error_max = 0x1p-23;

/// Coordinates below this in size can be measured: nothing below overflows.
inline constexpr double coordinate_max = 0x1p1000;

/// The box of a node with coordinates beyond that: all of space.
void set_unbounded_box(ObbNode& node);

/// Writes one projection for each triangle to `out` and returns that of all.
Projection project(std::span<const BuildTriangle> triangles,
                   std::span<const Vec3> vertices,
                   const Vec3& origin,
                   const std::array<float, 9>& axes,
                   std::span<Projection> out);

/// The projection of nothing.
[[nodiscard]] Projection empty_projection();

void extend(Projection& whole, const Projection& part);

/// Sets `center` and `half` of a node with these axes so that all vertices that `project` saw from
/// `origin` lie inside, in exact terms.
void set_box(const Projection& whole, const Vec3& origin, ObbNode& node);

} // namespace cd
