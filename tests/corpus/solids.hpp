// Solids and surfaces of the corpus, made with + - * / and sqrt in a fixed order and so
// bit-identical with every compiler and library, as those of shapes.hpp that are said to be.
#pragma once

#include "tests/support/shapes.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace cd::tests {

using Vec2 = std::array<double, 2>;

/// Returns 4 * 2^doublings points of the unit circle, evenly spaced, counter-clockwise from (1, 0):
/// each is the normalised sum of its neighbours.
[[nodiscard]] std::vector<Vec2> unit_circle(int doublings);

/// Returns `count + 1` values: first + i * step.
[[nodiscard]] std::vector<double> ticks(double first, double step, int count);

/// Makes a closed torus around z with 4 * 2^around by 4 * 2^across quadrilaterals.
[[nodiscard]] Mesh make_round_torus(double radius, double tube, int around, int across);

/// Makes a closed gear around z from 0 to `height` with 2^(doublings) trapezoidal teeth, the first
/// one along x.
[[nodiscard]] Mesh make_gear(int doublings, double root, double tip, double height, int layers);

/// Makes a closed prism over a simple counter-clockwise polygon whose first corner sees all others.
[[nodiscard]] Mesh make_prism(const std::vector<Vec2>& outline, double low, double high);

/// Makes an open height field of n by n cells with integer hundredths as heights, offset by
/// `corner`.
[[nodiscard]] Mesh make_terrain(std::uint64_t seed, int n, double cell, const Vec3& corner);

/// Returns the mesh without its last `count` triangles: open, if it was closed.
[[nodiscard]] Mesh without_last(const Mesh& mesh, std::size_t count);

} // namespace cd::tests
