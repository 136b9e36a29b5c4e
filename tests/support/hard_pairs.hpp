// Triangle pairs that floating point misjudges, by kind.
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

/// Maps the name of each kind to its maker.
[[nodiscard]] std::map<std::string, PairMaker> pair_makers();

/// Moves B so that a point of it (often on an edge or a corner) coincides in world space with such
/// a point of A, up to roundings.
[[nodiscard]] PosedPair nearly_touching(std::mt19937_64& random);

/// Makes lattices of tenths or integers, turns them about one axis (kept exactly) and moves them so
/// that corners or heights nominally coincide: what doubles compute as 0 must be 0. Some corners
/// lie on the axis.
[[nodiscard]] PosedPair turned_about_an_axis(std::mt19937_64& random);

/// Multiplies each coordinate by one of five powers of two, so far apart that products underflow.
void scale_far_apart(std::mt19937_64& random, PosedPair& pair);

[[nodiscard]] Corners random_corners(std::mt19937_64& random, double half_width);
/// Makes corners with integer coordinates from -reach to reach.
[[nodiscard]] Corners lattice_corners(std::mt19937_64& random, int reach);
/// Makes a point with integer coordinates from -reach to reach.
[[nodiscard]] Vec3 lattice_point(std::mt19937_64& random, int reach);
/// Returns a rounded point of a triangle: a vertex of B at this point nominally touches A.
[[nodiscard]] Vec3 point_on(std::mt19937_64& random, const Corners& t);
/// Moves some of the coordinates up or down by one ulp.
[[nodiscard]] Vec3 nudged(std::mt19937_64& random, Vec3 p);
[[nodiscard]] Corners scaled(Corners t, double factor);

} // namespace cd::tests
