// Solids and surfaces of the corpus, made with + - * / and sqrt in a fixed order and so
// bit-identical with every compiler and library.
#pragma once

#include "common/geometry/mesh.hpp"

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

/// Makes a closed box whose faces are divided at these ascending coordinates, which its vertices
/// have exactly.
[[nodiscard]] Mesh make_ticked_box(const std::vector<double>& x,
                                   const std::vector<double>& y,
                                   const std::vector<double>& z);
[[nodiscard]] Mesh make_box_between(const Vec3& low, const Vec3& high);

/// Makes a closed sphere of radius 1 around the origin: an octahedron, each triangle split in four.
[[nodiscard]] Mesh make_round_sphere(int subdivisions);
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

/// Returns the mesh with every coordinate times `factor`, rounded.
[[nodiscard]] Mesh scaled(const Mesh& mesh, double factor);
/// Returns the mesh without its last `count` triangles: open, if it was closed.
[[nodiscard]] Mesh without_last(const Mesh& mesh, std::size_t count);

} // namespace cd::tests
