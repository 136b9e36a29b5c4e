// The class of a scenario, as far as only the whole bodies can tell it.
#pragma once

#include "common/job/query.hpp"
#include "common/job/result.hpp"
#include "common/job/scenario.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/point_in_solid.hpp"

namespace cd {

/// What only the whole bodies can tell, for a result of `run_on_subtrees`: `surfaces_only` where a
/// body is open, and, from level count on, `inside` where nothing touches and some component of one
/// closed body lies in the other. With ignored pairs `inside` is not decided: parts that may stick
/// in each other say nothing about the rest. Called once by whoever merges. Returns what it took.
SettleStatistics settle_class(const ObbTree& a,
                              const ObbTree& b,
                              const Scenario& scenario,
                              const Query& query,
                              ScenarioResult& result);

/// True when `settle_class` may have more to do than set a flag: it then deserves a thread. (It is
/// cheap while the bodies' boxes are apart.)
[[nodiscard]] bool
settling_is_work(const ObbTree& a, const ObbTree& b, const ScenarioResult& result);

} // namespace cd
