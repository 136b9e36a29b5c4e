// Checks the outcomes of motions that workers send.
#pragma once

#include "master/compute/task_content.hpp"

namespace cd {

/// Returns what is wrong with the outcome of a decoded result to Question::Motion; null if nothing.
[[nodiscard]] const char* problem_of_motion(const JobMaterial& material,
                                            const Scenario& scenario,
                                            const ScenarioResult& result);

} // namespace cd
