// Runs one scenario again for the page: to verify its record, and to draw its contacts.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/job/query.hpp"
#include "common/job/result/record_file.hpp"
#include "common/job/scenario.hpp"
#include "common/job/trees_by_body.hpp"
#include "web/server/page_values.hpp"

#include <optional>

namespace cd {

/// Runs a scenario with the job's query, whose record must equal the stored one byte by byte, and,
/// unless that was exact at `level contacts`, once so with at most `limits::page_rows_max` pairs.
/// With the question of the distance, bodies that share no point are drawn with their nearest pair;
/// of lines the hits are drawn, at `level pairs`, and of each line only the first if the job asks
/// so. Motions are drawn at their event, or at their begin, and have these poses. `record` is the
/// stored result; without one, or if it says Failed, nothing is compared. After `stop`, the view
/// has no contacts and says so, and that it was not verified.
[[nodiscard]] ScenarioView repeat_scenario(const TreesByBody& trees,
                                           const Query& query,
                                           const Scenario& scenario,
                                           const std::optional<KeptRecord>& record,
                                           const StopCheck& stop);

} // namespace cd
