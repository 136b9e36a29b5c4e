// Tells clients how much more workers would help.
#pragma once

#include "master/dispatch/view/dispatch_view.hpp"
#include "master/dispatch/view/growth.hpp"
#include "master/jobs/job_table.hpp"

#include <optional>

namespace cd {

/// What the master itself takes for a scenario and has for analysis.
struct MasterCosts {
    double seconds_each = 0; ///< Time of the master's own thread for a scenario, s.
    double pool_threads = 1;
};

/// Sums up the work left of all running jobs. Jobs of which no scenario has been measured count as
/// the others. Empty if none has been.
[[nodiscard]] std::optional<WorkLeft>
work_left(const JobTable& jobs, const DispatchView& dispatch, const MasterCosts& costs);

/// Empty unless jobs run, workers take work, and some scenario has been measured.
[[nodiscard]] std::optional<Growth>
growth_of(const JobTable& jobs, const DispatchView& dispatch, const MasterCosts& costs);

} // namespace cd
