// Results that come when their job has ended, compared with those that were kept.
#pragma once

#include "common/core/result.hpp"
#include "common/job/result.hpp"
#include "master/result_store.hpp"
#include "proto/work_messages.hpp"

#include <vector>

namespace cd {

/// True when a worker's result, which nobody has settled, may be the one that was kept, which is.
[[nodiscard]] bool agrees(ScenarioResult late, const ScenarioResult& kept);

struct LateDifference {
    ScenarioResult late;
    ScenarioResult kept;
};

/// Those results of a message that are not what was kept. A failure that was kept tells nothing: it
/// may be the master's. Nor does a scenario without a result. Blocks for the disk; the bytes may be
/// hostile. Errors: BadFrame, TooLarge; Io when a record that was kept cannot be read.
[[nodiscard]] Result<std::vector<LateDifference>> late_differences(const ResultStore& kept,
                                                                   const Results& late);

/// The committed result of a scenario. Errors: Io, also when there is none.
[[nodiscard]] Result<ScenarioResult> kept_result(const ResultStore& results,
                                                 std::uint64_t scenario);

} // namespace cd
