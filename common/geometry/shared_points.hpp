// The points that two touching triangles share, in doubles.
#pragma once

#include "common/geometry/triangle_pair.hpp"

#include <vector>

namespace cd {

/// The corners of the set of points shared by two triangles whose class is known not to be
/// Separate: one point, the two ends of a segment, or a convex polygon of up to six, in order. All
/// corners are in one frame whose origin is the first corner of `a`.
///
/// Always one to six points without equal neighbours, always finite; where a difference of corners
/// overflowed, that origin. Accurate to some roundings of the largest coordinate, less where the
/// triangles are nearly coplanar; where rounding hides the shared set, one point of it.
[[nodiscard]] std::vector<Vec3>
approximate_shared_points(const Corners& a, const Corners& b, PairClass kind);

} // namespace cd
