// The oracle's slow twin: clipping of polygons in canonical rationals.
#pragma once

#include "common/pair/triangle_pair.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <vector>

namespace cd::tests {

using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = std::array<Rational, 3>;

/// Clips one triangle by everything that bounds the other, exactly, and looks at what is left.
/// Shares no code with the engine nor with `oracle_class`. Slow: some hundred microseconds.
[[nodiscard]] PairClass
clipping_oracle_class(const Corners& a, const Corners& b, const PosePair& poses);

/// The corners of the set of points that the triangles share, in the world: a segment's ends with
/// the lexicographically lesser first, a polygon's in the turn of A's corners from the
/// lexicographically least on.
[[nodiscard]] std::vector<RationalPoint>
clipping_oracle_points(const Corners& a, const Corners& b, const PosePair& poses);

/// A corner of a posed body in the world.
[[nodiscard]] RationalPoint clipping_oracle_world(const Pose& pose, const Vec3& corner);

/// Whether no finite double is nearer to `exact` than `value`, and none that is as near is even
/// instead; nor is it a negative 0.
[[nodiscard]] bool is_nearest_double(double value, const Rational& exact);

} // namespace cd::tests
