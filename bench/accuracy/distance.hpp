// Distances in doubles, to measure others' errors against: accurate to some roundings.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/tree/obb_tree.hpp"

#include <span>

namespace cd::bench {

/// Of a point from a triangle, which may be degenerate.
[[nodiscard]] double distance_to_triangle(const Vec3& p, const Corners& t);

/// Of a point from the convex hull of up to a few points in one plane; infinite from none.
[[nodiscard]] double distance_to_hull(const Vec3& p, std::span<const Vec3> corners);

/// Of two bodies in the world that do not touch, under rigid poses.
[[nodiscard]] double distance_of_bodies(const ObbTree& a, const ObbTree& b, const PosePair& poses);

} // namespace cd::bench
