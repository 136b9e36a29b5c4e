// Pairs of triangles that floating point gets wrong, by kind (NUMERICS, section 4).
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"

#include <functional>
#include <map>
#include <random>
#include <string>

namespace cd::tests {

struct PosedPair {
    Corners a;
    Corners b;
    PosePair poses;
};

using PairMaker = std::function<PosedPair(std::mt19937_64&)>;

/// A maker for each kind, by name.
[[nodiscard]] std::map<std::string, PairMaker> pair_makers();

/// B is moved so that a point of it, often on an edge or a corner, is in the world where such a
/// point of A is, but for some roundings.
[[nodiscard]] PosedPair nearly_touching(std::mt19937_64& random);

/// Lattices of tenths or of whole numbers turned about one axis, by a rotation that keeps it
/// exactly, and moved so that corners are nominally one point, or heights one height: what doubles
/// take for 0 must be 0. Some corners lie on the axis.
[[nodiscard]] PosedPair turned_about_an_axis(std::mt19937_64& random);

/// Multiplies each coordinate by one of five powers of two so far apart that products underflow.
void scale_far_apart(std::mt19937_64& random, PosedPair& pair);

[[nodiscard]] Corners random_corners(std::mt19937_64& random, double half_width);
/// Corners with whole coordinates from -reach to reach.
[[nodiscard]] Corners lattice_corners(std::mt19937_64& random, int reach);
/// Whole coordinates from -reach to reach.
[[nodiscard]] Vec3 lattice_point(std::mt19937_64& random, int reach);
/// A point of a triangle, rounded: a vertex of B put there touches A nominally.
[[nodiscard]] Vec3 point_on(std::mt19937_64& random, const Corners& t);
/// Some of the coordinates one step up or down.
[[nodiscard]] Vec3 nudged(std::mt19937_64& random, Vec3 p);
[[nodiscard]] Corners scaled(Corners t, double factor);

} // namespace cd::tests
