// The lines of a scene: their mesh, and where their bundles stand.
#pragma once

#include "client/bundle/scene_bundles.hpp"
#include "client/bundle/shot_plan.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace cd {

struct SceneLines {
    ShotsSpec spec; ///< With the box that the lines cover.
    std::shared_ptr<const Mesh> mesh;
    std::uint64_t bundles = 0; ///< At each step.
};

/// A scene's lines, and their scenarios.
struct StandingLines {
    SceneLines lines;
    std::unique_ptr<SceneBundles> poses;
};

/// Makes the lines of a scene. Without a box in `spec` they cover all targets at all steps. Errors:
/// as `shot_mesh`, `shot_poses`, `box_of_steps` and `SceneBundles::create`.
[[nodiscard]] Result<StandingLines> stand_lines(ShotsSpec spec,
                                                LineTargets targets,
                                                std::unique_ptr<StepPoses> poses,
                                                const std::filesystem::path& job_file,
                                                const StopCheck& stop);

} // namespace cd
