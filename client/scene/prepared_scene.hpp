// A scene whose inputs have been read and checked.
#pragma once

#include "client/bundle/scene_lines.hpp"
#include "client/scene/body_rules.hpp"
#include "client/scene/scene_bodies.hpp"
#include "client/spec/job_file.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/result/merge.hpp"
#include "common/scene/step_index.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// What reading the poses of a scene has told.
struct SceneFacts {
    std::vector<std::uint64_t> absences; ///< At how many steps each body is absent.
    /// Of motions: how far the rounding of keys has moved a point of any body, at most.
    std::optional<double> moved;
    std::vector<std::string> zeros; ///< Columns missing in [poses], which count as 0.
    std::vector<std::string> notes; ///< What became of curves; a sentence each.
};

struct PreparedScene {
    SceneBodies scene;
    std::vector<RuleEffect> effects; ///< Of each rule.
    /// Pairs of bodies that the rules ignore; with lines, bodies that they may not hit.
    std::uint64_t ignored_pairs = 0;
    std::vector<IgnoredRange> ignored; ///< Ignored parts of other pairs.
    /// For each body, whether it has one pose at all steps; with lines also for these, which have
    /// one for each bundle.
    std::vector<bool> are_fixed;
    std::unique_ptr<PoseSource> poses; ///< The scenarios of all steps.
    /// The steps: their scenarios, and what became of all pairs.
    std::shared_ptr<const StepIndex> steps;
    SceneFacts facts;
    std::optional<SceneLines> lines; ///< A body after all of `scene`, with which these are tested.
    SceneHead head;
    Query query; ///< With a clearance that covers the chord of curves; without `Query::ignored`.
    std::vector<std::string> warnings; ///< A sentence each, naming the file.
};

/// Returns how far apart bodies may be so that the query asks about them: its clearance or `up_to`,
/// or 0; of motions as `reach_of_motions`.
[[nodiscard]] double reach_of(const Query& query);

/// Imports the meshes of a job with [bodies], makes its bodies, applies its rules, opens its poses
/// and counts the pairs of all steps. Unless `quiet`, a line on stderr names each step longer than
/// half a second. Errors: BadInput, NotFound and Io, each naming the file; Interrupted.
[[nodiscard]] Result<PreparedScene>
prepare_scene(const JobSpec& spec, bool quiet, const StopCheck& stop = {});

} // namespace cd
