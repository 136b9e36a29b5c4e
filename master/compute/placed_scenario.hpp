// A scenario with its position in the job's hand-out order.
#pragma once

#include "common/core/result.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/job/scenario.hpp"

#include <cstdint>

namespace cd {

struct PlacedScenario {
    Scenario scenario;
    std::uint64_t position = 0; ///< In the job's hand-out order; `scenario.index` is as submitted.
};

/// Reads one scenario of a job by its index as submitted. Blocks on the disk. Errors: Io, BadInput
/// of the poses.
[[nodiscard]] Result<PlacedScenario> read_one(OrderedPoses& poses, std::uint64_t index);

} // namespace cd
