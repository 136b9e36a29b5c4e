#include "web/server/scene/scene_rows.hpp"

#include "common/core/errors.hpp"
#include "common/core/limits/web.hpp"

namespace cd {

Result<std::vector<ScenePlace>> scene_places(std::span<const Scenario> scenarios,
                                             const StepIndex& steps) {
    std::vector<ScenePlace> places;
    places.reserve(scenarios.size());
    for (const Scenario& scenario : scenarios) {
        if (!scenario.step || scenario.index >= steps.count()) {
            return Error{ErrorCode::BadFrame, "a scenario of the scene has no step"};
        }
        places.push_back({steps.step_of(scenario.index), scenario.body_a, scenario.body_b});
    }
    return places;
}

Result<std::vector<MotionKeys>> scene_motions(std::span<const Scenario> scenarios) {
    std::vector<MotionKeys> keys;
    keys.reserve(scenarios.size());
    for (const Scenario& scenario : scenarios) {
        if (!scenario.to) {
            return Error{ErrorCode::NotFound, "the job has no motions"};
        }
        keys.push_back({scenario.poses, *scenario.to});
    }
    return keys;
}

Result<std::vector<StepRow>> step_rows(const StepIndex& steps, const ScenarioChoice& choice) {
    CD_TRY(choice.check(steps.steps(), limits::page_scenarios_max, "step"));
    std::vector<StepRow> rows;
    rows.reserve(choice.size());
    for (std::uint64_t i = 0; i < choice.size(); ++i) {
        const std::uint64_t step = choice.at(i, steps.steps());
        rows.push_back({steps.first_of(step), steps.time_of(step)});
    }
    return rows;
}

Result<std::shared_ptr<const StepIndex>> steps_of(const Submit& submit) {
    if (!submit.poses.scene) {
        return std::shared_ptr<const StepIndex>();
    }
    return unpack_steps(submit.poses.scene->steps, submit.scenarios);
}

void add_step_time(const StepIndex* steps, std::uint64_t scenario, ScenarioView& view) {
    if (steps != nullptr && view.scene && scenario < steps->count()) {
        view.scene->step = steps->step_of(scenario);
        view.time = steps->time_of(view.scene->step);
    }
}

Error no_scene() {
    return {ErrorCode::NotFound, "the job is no scene: it has two bodies and no steps"};
}

} // namespace cd
