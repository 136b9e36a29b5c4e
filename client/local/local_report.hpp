// The report of a run in this process.
#pragma once

#include "client/local/local_run.hpp"
#include "client/report/report.hpp"

namespace cd {

/// Returns a report of the outcome of a run of `query` on so many threads, without findings and
/// contact map.
[[nodiscard]] RunReport report_of(const RunOutcome& outcome, const Query& query, unsigned threads);

} // namespace cd
