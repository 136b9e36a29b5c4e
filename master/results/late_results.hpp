// Compares results that arrive after the end of their job with the stored ones.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/result/result.hpp"
#include "master/journal/result_store.hpp"
#include "proto/messages/work_messages.hpp"

#include <optional>

namespace cd {

/// True if settling could turn the worker's result `late` into `settled`.
[[nodiscard]] bool agrees(ScenarioResult late, const ScenarioResult& settled);

struct LateDifference {
    ScenarioResult late;
    ScenarioResult kept;
};

/// Returns the first result of a message that differs from the stored one, if any. Ignores stored
/// failures, which may be the master's, and scenarios without a stored result. Blocks on the disk;
/// the bytes may be hostile. Errors: BadFrame, TooLarge; Io when a stored record cannot be read;
/// Interrupted.
[[nodiscard]] Result<std::optional<LateDifference>>
late_difference(const ResultStore& kept, const Results& late, const StopCheck& stop = {});

/// The committed result of a scenario. Errors: Io, also if there is none.
[[nodiscard]] Result<ScenarioResult> kept_result(const ResultStore& results,
                                                 std::uint64_t scenario);

} // namespace cd
