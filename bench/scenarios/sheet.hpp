// Surfaces from which generated models are put together: each is a grid of quadrilaterals, each
// cut in two. Only + - * / and sqrt, so that a model has the same bits on every host.
#pragma once

#include "common/geometry/mesh.hpp"

#include <Eigen/Geometry>

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace cd::bench {

/// A point for u and v in [0, 1].
using Surface = std::function<Vec3(double u, double v)>;

struct Sheet {
    Surface at;
    double share = 1;         ///< Of the model's triangles, relative to its other sheets.
    double cells_u_per_v = 1; ///< Far from the surface's own proportions: long thin triangles.
    bool closed_u = false;    ///< u = 1 is u = 0 again.
    bool closed_v = false;
};

/// (cos, sin) of `turn` full turns, off by up to 0.01 in the angle, on the circle to rounding.
struct CirclePoint {
    double cos = 1;
    double sin = 0;
};
[[nodiscard]] CirclePoint circle_point(double turn);

/// The same direction on a circle squeezed into its square: |c|^4 + |s|^4 = 1.
[[nodiscard]] CirclePoint boxy_point(double turn);

/// 0 at whole numbers, 1 halfway, straight between.
[[nodiscard]] double saw(double x);

/// One mesh with about `triangles` triangles, coordinates rounded to floats. A sheet with fewer
/// triangles to its share than its shape needs is left out.
[[nodiscard]] std::shared_ptr<const Mesh> join_sheets(std::span<const Sheet> sheets,
                                                      std::uint64_t triangles);

/// A tube of half sizes `wide` and `high` along a polyline; square in section if `boxy`.
struct TubeShape {
    std::vector<Vec3> path; ///< At least two points; no piece is parallel to `up`.
    Vec3 up = Vec3(0, 0, 1);
    double wide = 0.01;
    double high = 0.01;
    bool boxy = false;
};
[[nodiscard]] Surface tube(TubeShape shape);

} // namespace cd::bench
