// Divides a triangle or a segment where another surface meets it, and visits one point of each
// piece.
#pragma once

#include "common/pair/numbers/dyadic.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace cd {

using Rational = boost::multiprecision::cpp_rational;
using PlanePoint = std::array<Rational, 2>;

/// A segment in the plane; a point if both ends are equal.
struct PlaneCut {
    PlanePoint from;
    PlanePoint to;
};

[[nodiscard]] Rational to_rational(const Dyadic& value);

/// Splits the triangle, which has nonzero area, into convex cells such that no cut has a point in
/// the interior of a cell. Calls `question` with the centre of each cell, an interior point, until
/// it returns true. Splits only cells that a cut enters, along the cut's line. Exact.
[[nodiscard]] bool any_cell_centre(const std::array<PlanePoint, 3>& triangle,
                                   std::span<const PlaneCut> cuts,
                                   const std::function<bool(const PlanePoint&)>& question);

/// Splits the segment from 0 to 1 at the parameters `cuts`, which lie in it. Calls `question` with
/// the midpoint of each piece until it returns true. Exact.
[[nodiscard]] bool any_piece_centre(std::vector<Rational> cuts,
                                    const std::function<bool(const Rational&)>& question);

} // namespace cd
