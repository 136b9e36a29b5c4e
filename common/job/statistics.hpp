// Statistics of a job's cost. They are never part of a result or of the digest.
#pragma once

#include "common/solid/settle_statistics.hpp"
#include "common/tree/query_statistics.hpp"

#include <cstdint>

namespace cd {

/// The cost of deciding whether one body lies inside the other, or penetrates it without a proper
/// pair, without the contact search.
struct InsideStatistics {
    std::uint64_t scenarios = 0; ///< Number of scenarios in which this was decided.
    double seconds = 0;    ///< Wall-clock time of one thread, in seconds; see `Settler::settle`.
    SettleStatistics work; ///< Counts of tests; they stay on the machine that settled.

    InsideStatistics& operator+=(const InsideStatistics& other);
};

/// Sums over a job's scenarios.
struct JobStatistics {
    QueryStatistics search;
    InsideStatistics inside;

    JobStatistics& operator+=(const JobStatistics& other);
};

} // namespace cd
