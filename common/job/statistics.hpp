// What the answers of a job cost. Never part of a result or of the digest.
#pragma once

#include "common/job/query.hpp"
#include "common/job/result.hpp"
#include "common/job/scenario.hpp"
#include "common/job/settle.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/point_in_solid.hpp"

#include <cstdint>

namespace cd {

/// The cost of telling whether one body lies inside the other, or penetrates it without a proper
/// pair, apart from all else.
struct InsideStatistics {
    std::uint64_t scenarios = 0; ///< In which it was looked at.
    double seconds = 0;          ///< Of one thread, by the clock on the wall.
    SettleStatistics work;       ///< What was looked at; stays on the machine that settled.

    InsideStatistics& operator+=(const InsideStatistics& other);
};

/// Summed over a job's scenarios.
struct JobStatistics {
    QueryStatistics search;
    InsideStatistics inside;

    JobStatistics& operator+=(const JobStatistics& other);
};

/// `settle_class` (settle.hpp), and what it cost.
[[nodiscard]] InsideStatistics settle_with_cost(const ObbTree& a,
                                                const ObbTree& b,
                                                const Scenario& scenario,
                                                const Query& query,
                                                ScenarioResult& result,
                                                const SettleOptions& options = {});

} // namespace cd
