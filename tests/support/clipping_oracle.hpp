// A slow reference for the oracle: clips polygons in canonical rationals.
#pragma once

#include "common/pair/triangle_pair.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <vector>

namespace cd::tests {

using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = std::array<Rational, 3>;

/// Clips one triangle exactly by all bounds of the other and classifies the remainder. Shares no
/// code with the engine or `oracle_class`. Takes some hundred microseconds.
[[nodiscard]] PairClass
clipping_oracle_class(const Corners& a, const Corners& b, const PosePair& poses);

/// Returns the corners, in world space, of the intersection of the triangles. A segment starts at
/// its lexicographically lesser end; a polygon turns like A and starts at its least corner.
[[nodiscard]] std::vector<RationalPoint>
clipping_oracle_points(const Corners& a, const Corners& b, const PosePair& poses);

/// Returns a corner of a posed body in world space.
[[nodiscard]] RationalPoint clipping_oracle_world(const Pose& pose, const Vec3& corner);

/// True if `value` is the finite double nearest to `exact`, ties to even, and not a negative 0.
[[nodiscard]] bool is_nearest_double(double value, const Rational& exact);

} // namespace cd::tests
