// What the categories of pairs are made of.
#pragma once

#include "tests/support/hard_pairs.hpp"

#include <map>
#include <string>

namespace cd::tests {

using PairMakers = std::map<std::string, PairMaker>;

/// In exact contact, or nearly: the pairs are made for identity poses, then posed together.
void add_contact_makers(PairMakers& makers);
/// Slivers, degenerate triangles and extreme magnitudes.
void add_extreme_makers(PairMakers& makers);
/// Of poses: turns exact and rounded, one rotation written in several ways.
void add_pose_makers(PairMakers& makers);
/// Triangles of whole-mesh scenes that are near each other.
void add_scene_makers(PairMakers& makers);

/// Both triangles under one pose, whose kind is drawn: exact contacts stay exact contacts.
[[nodiscard]] PosedPair posed_together(std::mt19937_64& random, PosedPair pair);
/// Corners in any order, and A and B perhaps swapped.
[[nodiscard]] PosedPair shuffled(std::mt19937_64& random, PosedPair pair);

} // namespace cd::tests
