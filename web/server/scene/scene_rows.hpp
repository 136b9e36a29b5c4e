// The steps of a scene, and bodies and motions of its scenarios, as the page asks for them.
#pragma once

#include "common/core/result.hpp"
#include "common/job/scenario.hpp"
#include "common/scene/step_index.hpp"
#include "web/server/page_request.hpp"
#include "web/server/page_values.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cd {

/// Returns where each scenario of a scene belongs. The step is that of the scenario's number: with
/// lines, the step that the scenario itself has names its bundle, too. Errors: BadFrame for a
/// scenario without a step.
[[nodiscard]] Result<std::vector<ScenePlace>> scene_places(std::span<const Scenario> scenarios,
                                                           const StepIndex& steps);

/// Returns the keys of each motion, of a scene or of two bodies. Errors: NotFound for a scenario
/// that is no motion.
[[nodiscard]] Result<std::vector<MotionKeys>> scene_motions(std::span<const Scenario> scenarios);

/// Returns the chosen steps; element i of a sample is step floor(i * steps / sample). Errors:
/// BadInput for steps that the scene does not have, or more than `limits::page_scenarios_max`.
[[nodiscard]] Result<std::vector<StepRow>> step_rows(const StepIndex& steps,
                                                     const ScenarioChoice& choice);

/// Returns the steps of a job that was submitted; null unless it is a scene. Errors: as
/// `unpack_steps`.
[[nodiscard]] Result<std::shared_ptr<const StepIndex>> steps_of(const Submit& submit);

/// Sets the view's step to that of the scenario's number, and its time. Of a job that is no scene,
/// `steps` is null, and nothing is set.
void add_step_time(const StepIndex* steps, std::uint64_t scenario, ScenarioView& view);

/// The error for a question about steps or pairs of bodies in a job that is no scene: NotFound.
[[nodiscard]] Error no_scene();

} // namespace cd
