// The points that two touching triangles share, in doubles.
#pragma once

#include "common/geometry/triangle_pair.hpp"

#include <vector>

namespace cd {

/// The corners of the set of points shared by two triangles whose class is known not to be
/// Separate: one point, the two ends of a segment, or a convex polygon of up to six. All corners
/// are in one frame whose origin is near the triangles. Always at least one point, always finite
/// for finite input; accurate to some roundings of the triangles' size, less where they are nearly
/// coplanar.
[[nodiscard]] std::vector<Vec3>
approximate_shared_points(const Corners& a, const Corners& b, PairClass kind);

} // namespace cd
