// Scenarios with their labels.
#pragma once

#include "common/job/poses/pose_labels.hpp"
#include "common/job/scenario.hpp"

#include <vector>

namespace cd {

/// Some scenarios of a job in their order. The labels are empty unless the pose file has some.
struct LabelledScenarios {
    std::vector<Scenario> scenarios;
    PoseLabels labels;
};

} // namespace cd
