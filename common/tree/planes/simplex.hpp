// The point of a simplex that is nearest to the origin.
#pragma once

#include "common/geometry/types.hpp"

#include <array>
#include <cstddef>

namespace cd {

/// A convex combination of the corners of a simplex.
struct NearestOfSimplex {
    std::array<double, 4> weights{}; ///< Not negative; their sum is 1 within 2^-48.
    Vec3 point = Vec3::Zero();       ///< The combination.
};

/// Returns the combination of `count` corners, 1 to 4, that is nearest to the origin, approximately
/// (Ericson, Real-Time Collision Detection, 2005, section 5.1). The weights are right in any case.
[[nodiscard]] NearestOfSimplex nearest_of_simplex(const std::array<Vec3, 4>& corners,
                                                  std::size_t count);

/// A part of the radius that bounds what rounding does to a combination; see `distance_bound`.
inline constexpr double distance_rounding = 0x1p-46;

/// Bounds the distance of a point from the hull of the corners of which `nearest` is a combination,
/// however the weights were found. Corners are relative to the point, in doubles. They come from
/// floats that are within `radius` of the origin, directly or less a third such point.
///
/// With u = 2^-53, each component of a corner is below 2 radius and within 6 u radius of its exact
/// value. Four products and three sums with weights whose sum is 1 add 9 u radius: together 26 u
/// radius for the length, which `distance_rounding` exceeds fourfold. The factor covers the
/// rounding of the length and the sum of the weights.
[[nodiscard]] inline double distance_bound(const NearestOfSimplex& nearest, double radius) {
    return nearest.point.norm() * (1 + 0x1p-40) + distance_rounding * radius;
}

} // namespace cd
