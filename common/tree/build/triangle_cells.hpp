// A triangle or a segment cut up along what another surface leaves in it: one point of each piece.
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

/// A segment in the plane; a point if both ends are one.
struct PlaneCut {
    PlanePoint from;
    PlanePoint to;
};

[[nodiscard]] Rational to_rational(const Dyadic& value);

/// Splits the triangle, which has area, into convex cells such that no cut has a point in the
/// interior of a cell, and asks for the centre of each, an interior point, until the answer is yes.
/// Only cells that a cut enters are split, along its line. Exact.
[[nodiscard]] bool any_cell_centre(const std::array<PlanePoint, 3>& triangle,
                                   std::span<const PlaneCut> cuts,
                                   const std::function<bool(const PlanePoint&)>& question);

/// The same for the segment from 0 to 1, cut at the given places, which lie in it.
[[nodiscard]] bool any_piece_centre(std::vector<Rational> cuts,
                                    const std::function<bool(const Rational&)>& question);

} // namespace cd
