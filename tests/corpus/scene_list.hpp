// Helpers that build the lists of scenes.
#pragma once

#include "tests/corpus/scenes.hpp"

namespace cd::tests {

using Scenes = std::vector<Scene>;

void add_box_scenes(Scenes& scenes);
void add_round_scenes(Scenes& scenes);
void add_building_scenes(Scenes& scenes);
void add_odd_scenes(Scenes& scenes);

[[nodiscard]] Body solid(Mesh mesh);
[[nodiscard]] Body surface(Mesh mesh); ///< Makes an open body.

} // namespace cd::tests
