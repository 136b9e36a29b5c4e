// Results that come when their job has ended, compared with those that were kept.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/result/result.hpp"
#include "master/journal/result_store.hpp"
#include "proto/messages/work_messages.hpp"

#include <optional>

namespace cd {

/// True when a worker's result, which nobody has settled, may be the one that is given, which is.
[[nodiscard]] bool agrees(ScenarioResult late, const ScenarioResult& settled);

struct LateDifference {
    ScenarioResult late;
    ScenarioResult kept;
};

/// The first result of a message that is not what was kept, if there is any. A failure that was
/// kept tells nothing: it may be the master's. Nor does a scenario without a result. Blocks for the
/// disk; the bytes may be hostile. Errors: BadFrame, TooLarge; Io when a record that was kept
/// cannot be read; Interrupted.
[[nodiscard]] Result<std::optional<LateDifference>>
late_difference(const ResultStore& kept, const Results& late, const StopCheck& stop = {});

/// The committed result of a scenario. Errors: Io, also when there is none.
[[nodiscard]] Result<ScenarioResult> kept_result(const ResultStore& results,
                                                 std::uint64_t scenario);

} // namespace cd
