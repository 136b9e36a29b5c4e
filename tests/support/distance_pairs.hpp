// Triangle pairs whose distance floating point misjudges, by kind.
#pragma once

#include "tests/support/hard_pairs.hpp"

#include <map>
#include <random>
#include <string>
#include <vector>

namespace cd::tests {

/// Maps the name of each kind to its maker: all kinds of `pair_makers` moved apart by 1e-17 to 1e3
/// of their size, and kinds that are hard for distances alone. Some pairs share a point.
[[nodiscard]] std::map<std::string, PairMaker> distance_pair_makers();

/// Moves B, in the world, by 1e-17 to 1e3 of the size of the pair's triangles.
[[nodiscard]] PosedPair moved_apart(std::mt19937_64& random, PosedPair pair);

/// Returns numbers to compare with a distance that rounds to `rounded`: this number, both its
/// neighbours, a number in decimals near it, others near it, and the least and greatest possible.
[[nodiscard]] std::vector<double> bounds_around(std::mt19937_64& random, double rounded);

} // namespace cd::tests
