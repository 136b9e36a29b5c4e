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

/// A triangle of a node that is being built.
struct BuildTriangle {
    Triangle vertices{};
    std::uint32_t id = 0; ///< Index of the triangle in the mesh.
};

struct Interval {
    double low = 0;
    double high = 0;
};

/// The intervals that a triangle, or all triangles of a node, cover on the three axes of a frame,
/// relative to an origin. They are rounded.
using Projection = std::array<Interval, 3>;

/// The body's own axes, as an exact frame.
inline constexpr std::array<float, 9> body_axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/// Sums of the coordinates of triangles' corners, relative to an origin, and of their products.
/// A vertex counts once for each triangle that uses it, as in Eberly, 3D Game Engine Design (2001),
/// fitting points with a Gaussian.
struct Moments {
    Vec3 sum = Vec3::Zero();
    SymmetricMatrix products{};
    std::size_t corners = 0;

    Moments& operator+=(const Moments& other);
};

/// Returns the moments of the triangles, added up in their order: equal triangles in equal order
/// give equal bits.
[[nodiscard]] Moments sum_moments(std::span<const BuildTriangle> triangles,
                                  std::span<const Vec3> vertices,
                                  const Vec3& origin);

/// Returns the frames of the Gaussian distributions fitted to the corners of some nodes: the
/// eigenvectors of their covariances, narrowest direction first. The rows are orthonormal within
/// `axes_error_max`. Where numbers overflow, the frame is the body's own axes.
[[nodiscard]] std::vector<std::array<float, 9>> fit_axes(std::span<const Moments> nodes);

/// Bounds each |entry| of F F' - I for the frame F of every node.
inline constexpr double axes_error_max = 0x1p-23;

/// Bound on absolute coordinates below which projections and moments do not overflow.
inline constexpr double coordinate_max = 0x1p1000;

/// Sets the box of a node with coordinates beyond `coordinate_max` to all of space.
void set_unbounded_box(ObbNode& node);

/// Writes one projection for each triangle to `out` and returns the projection of all of them.
Projection project(std::span<const BuildTriangle> triangles,
                   std::span<const Vec3> vertices,
                   const Vec3& origin,
                   const std::array<float, 9>& axes,
                   std::span<Projection> out);

/// Returns the projection of an empty set.
[[nodiscard]] Projection empty_projection();

void extend(Projection& whole, const Projection& part);

/// Sets `center` and `half` of a node whose axes are set, so that all vertices that `project`
/// measured from `origin` lie inside, in exact terms.
void set_box(const Projection& whole, const Vec3& origin, ObbNode& node);

} // namespace cd
