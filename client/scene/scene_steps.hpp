// The poses of a scene's bodies at each step, from the job file and the files that it names.
#pragma once

#include "client/curves/step_curves.hpp"
#include "client/poses/traffic.hpp"
#include "client/scene/scene_bodies.hpp"
#include "client/spec/scene_spec.hpp"
#include "common/core/result.hpp"
#include "common/scene/scene_poses.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace cd {

struct OpenedSteps {
    std::unique_ptr<StepPoses> poses;
    std::vector<bool> are_fixed; ///< For each body, whether its pose is the same at all steps.
    std::vector<std::string> warnings; ///< A sentence each, naming the file.
    std::vector<std::string> zeros; ///< Columns missing in the file of [poses], which count as 0.
    std::vector<StepRates> rates;   ///< Of each file that has velocities.
};

/// Opens the poses of all bodies and checks them. A body has its `pose`, a file of its own, or rows
/// of [poses]; the parts of a split mesh may have none, and are then at the identity. The vehicles
/// of `traffic`, which may be null, are absent at the steps that do not have them. Without poses
/// that change there is one step.
///
/// Errors: those of `open_pose_file` and `open_scene_poses`; BadInput naming the line and the body,
/// for a body without a pose or with two, and for files of different numbers of steps or times.
[[nodiscard]] Result<OpenedSteps> open_steps(const SceneSpec& spec,
                                             const SceneBodies& scene,
                                             const std::filesystem::path& job_file,
                                             std::shared_ptr<const RoadTraffic> traffic = nullptr);

} // namespace cd
