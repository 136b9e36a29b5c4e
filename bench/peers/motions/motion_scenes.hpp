// The bodies and paths of the comparison of motions.
#pragma once

#include "bench/peers/motions/motion_engine.hpp"
#include "bench/peers/scenes.hpp"

#include <string>
#include <vector>

namespace cd::bench {

struct MotionSceneOptions {
    SceneOptions scenes; ///< Each pose of a scene gives a path of each kind.
    std::string only;    ///< Scenes with this in their names.
};

/// Returns the scenes, but for those with missing files, which are named on stderr:
/// - drivaer x sedan and hatchback x toy truck, in their poses of contact: `onto` and `past` of
///   `MotionPaths`, 3 m long, with a turn of 30 degrees and without one;
/// - two boxes that come towards each other, as in fcl #555, beside each other by random amounts;
/// - a wall 1e-6 thick, and a box of 1 mm that passes it in one step, likewise.
[[nodiscard]] std::vector<MotionScene> motion_scenes(const MotionSceneOptions& options);

} // namespace cd::bench
