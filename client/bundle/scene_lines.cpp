#include "client/bundle/scene_lines.hpp"

#include "common/core/errors.hpp"

#include <utility>

namespace cd {

Result<StandingLines> stand_lines(ShotsSpec spec,
                                  LineTargets targets,
                                  std::unique_ptr<StepPoses> poses,
                                  const std::filesystem::path& job_file,
                                  const StopCheck& stop) {
    if (!spec.box) {
        const auto box = box_of_steps(targets, *poses, stop);
        if (!box) {
            return box.error().code == ErrorCode::BadInput ? bad_input(job_file, box.error().detail)
                                                           : box.error();
        }
        spec.box = box.value();
    }
    Mesh mesh = CD_TRY(shot_mesh(spec, *spec.box));
    StandingBundles bundles{CD_TRY(shot_poses(spec, *spec.box)), bounding_box(mesh.vertices())};
    StandingLines standing;
    standing.lines = {
        std::move(spec), std::make_shared<const Mesh>(std::move(mesh)), bundles.poses.size()};
    standing.poses = CD_TRY(
        SceneBundles::create(std::move(targets), std::move(bundles), std::move(poses), stop));
    return standing;
}

} // namespace cd
