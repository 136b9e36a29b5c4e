#include "common/job/answer_poses.hpp"

#include "common/motion/body_path.hpp"

#include <cmath>
#include <cstdint>
#include <optional>

namespace cd {

namespace {

/// Returns the pose at tau between two keys; the first one if there is no path.
Pose between(const Pose& from, const Pose& to, double tau) {
    const Result<BodyPath> path = path_between(from, to);
    return path ? pose_at(path.value(), tau) : from;
}

} // namespace

PosePair poses_of_answer(const Scenario& scenario, const ScenarioResult& result) {
    const std::optional<std::uint32_t> event =
        result.motion && scenario.to ? result.motion->event() : std::nullopt;
    if (!event) {
        return scenario.poses;
    }
    const double tau = std::ldexp(*event, -static_cast<int>(result.motion->depth));
    return {between(scenario.poses.a, scenario.to->a, tau),
            between(scenario.poses.b, scenario.to->b, tau)};
}

Scenario at_answer(const Scenario& scenario, const ScenarioResult& result) {
    Scenario at = scenario;
    at.poses = poses_of_answer(scenario, result);
    at.to.reset();
    return at;
}

} // namespace cd
