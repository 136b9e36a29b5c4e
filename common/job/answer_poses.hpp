// Under which poses a scenario's answer holds.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/job/result/result.hpp"
#include "common/job/scenario.hpp"

namespace cd {

/// Returns the poses that the class and the pairs of a scenario's result are about: those of the
/// motion's event, without one those of its begin; without a motion those of the scenario. The
/// result is that of the scenario.
[[nodiscard]] PosePair poses_of_answer(const Scenario& scenario, const ScenarioResult& result);

/// Returns the scenario at rest under the poses of its answer.
[[nodiscard]] Scenario at_answer(const Scenario& scenario, const ScenarioResult& result);

} // namespace cd
