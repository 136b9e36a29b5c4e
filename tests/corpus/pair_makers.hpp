// Makers of the pair categories.
#pragma once

#include "tests/support/hard_pairs.hpp"

#include <map>
#include <string>

namespace cd::tests {

using PairMakers = std::map<std::string, PairMaker>;

/// Exact or near contacts: made for identity poses, then posed together.
void add_contact_makers(PairMakers& makers);
/// Slivers, degenerate triangles and extreme magnitudes.
void add_extreme_makers(PairMakers& makers);
/// Special poses: exact and rounded turns, one rotation written in several ways.
void add_pose_makers(PairMakers& makers);
/// Neighbouring triangles of whole-mesh scenes.
void add_scene_makers(PairMakers& makers);

/// Poses both triangles with one random kind of pose, which keeps exact contacts exact.
[[nodiscard]] PosedPair posed_together(std::mt19937_64& random, PosedPair pair);
/// Shuffles the corners and perhaps swaps A and B.
[[nodiscard]] PosedPair shuffled(std::mt19937_64& random, PosedPair pair);
/// Shuffles, then poses both triangles.
[[nodiscard]] PosedPair finished(std::mt19937_64& random, PosedPair pair);

} // namespace cd::tests
