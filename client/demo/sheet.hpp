// Surfaces of generated models: each is a grid of quadrilaterals, each split into two triangles.
// Uses only + - * / and sqrt, so that a model has the same bits on every host.
#pragma once

#include "common/geometry/mesh.hpp"

#include <Eigen/Geometry>

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// Returns a point for u and v in [0, 1].
using Surface = std::function<Vec3(double u, double v)>;

struct Sheet {
    Surface at;
    double share = 1; ///< Share of the model's triangles, relative to its other sheets.
    /// Cell proportions; values far from the surface's own give long thin triangles.
    double cells_u_per_v = 1;
    bool closed_u = false; ///< u = 1 coincides with u = 0.
    bool closed_v = false;
    std::string part; ///< Name of the part that the sheet belongs to.
};

/// (cos, sin) of `turn` full turns: the angle is off by up to 0.01, the radius only by rounding.
struct CirclePoint {
    double cos = 1;
    double sin = 0;
};
[[nodiscard]] CirclePoint circle_point(double turn);

/// Returns the direction on a rounded square: |c|^4 + |s|^4 = 1.
[[nodiscard]] CirclePoint boxy_point(double turn);

/// Triangle wave: 0 at whole numbers, 1 halfway, linear between.
[[nodiscard]] double saw(double x);

/// Returns one mesh of about `triangles` triangles, coordinates rounded to floats. Omits a sheet
/// whose share is smaller than its shape needs. Consecutive sheets of one part become one part.
[[nodiscard]] std::shared_ptr<const Mesh> join_sheets(std::span<const Sheet> sheets,
                                                      std::uint64_t triangles);

/// A tube with half sizes `wide` and `high` along a polyline; rectangular in section if `boxy`.
struct TubeShape {
    std::vector<Vec3> path; ///< At least two points; no piece is parallel to `up`.
    Vec3 up = Vec3(0, 0, 1);
    double wide = 0.01;
    double high = 0.01;
    bool boxy = false;
};
[[nodiscard]] Surface tube(TubeShape shape);

} // namespace cd
