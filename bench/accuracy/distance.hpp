// Reference distances in doubles, accurate to a few roundings.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/tree/obb_tree.hpp"

#include <span>

namespace cd::bench {

/// Returns the distance of a point from a triangle, which may be degenerate.
[[nodiscard]] double distance_to_triangle(const Vec3& p, const Corners& t);

/// Returns the distance of a point from the convex hull of a few coplanar points; infinite without
/// points.
[[nodiscard]] double distance_to_hull(const Vec3& p, std::span<const Vec3> corners);

/// Returns the distance of two separate bodies in the world, under rigid poses.
[[nodiscard]] double distance_of_bodies(const ObbTree& a, const ObbTree& b, const PosePair& poses);

} // namespace cd::bench
