// Solids and surfaces of the corpus. Made with + - * / and sqrt in a fixed order, so that they have
// the same bits with every compiler and library.
#pragma once

#include "common/geometry/mesh.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace cd::tests {

using Vec2 = std::array<double, 2>;

/// 4 * 2^doublings points of the unit circle, evenly spaced, counter-clockwise from (1, 0): each is
/// the normalised sum of its neighbours.
[[nodiscard]] std::vector<Vec2> unit_circle(int doublings);

/// `count + 1` values from `first` in steps of `step`: first + i * step.
[[nodiscard]] std::vector<double> ticks(double first, double step, int count);

/// A closed box whose faces are divided at these ascending coordinates, which are the vertices'
/// coordinates exactly.
[[nodiscard]] Mesh make_ticked_box(const std::vector<double>& x,
                                   const std::vector<double>& y,
                                   const std::vector<double>& z);
[[nodiscard]] Mesh make_box_between(const Vec3& low, const Vec3& high);

/// A closed sphere of radius 1 around the origin: an octahedron, each triangle split in four.
[[nodiscard]] Mesh make_round_sphere(int subdivisions);
/// A closed torus around z with 4 * 2^around by 4 * 2^across quadrilaterals.
[[nodiscard]] Mesh make_round_torus(double radius, double tube, int around, int across);

/// A closed gear around z from 0 to `height` with 2^(doublings) teeth of trapezoid shape, the first
/// one pointing along x.
[[nodiscard]] Mesh make_gear(int doublings, double root, double tip, double height, int layers);

/// A closed prism over a simple polygon given counter-clockwise whose first corner sees all others.
[[nodiscard]] Mesh make_prism(const std::vector<Vec2>& outline, double low, double high);

/// An open height field of n by n cells with whole hundredths as heights, `corner` added to all.
[[nodiscard]] Mesh make_terrain(std::uint64_t seed, int n, double cell, const Vec3& corner);

/// The mesh with every coordinate times `factor`, rounded.
[[nodiscard]] Mesh scaled(const Mesh& mesh, double factor);
/// The mesh without its last `count` triangles: open, if it was closed.
[[nodiscard]] Mesh without_last(const Mesh& mesh, std::size_t count);

} // namespace cd::tests
