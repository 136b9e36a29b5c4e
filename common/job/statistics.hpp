// What the answers of a job cost. Never part of a result or of the digest.
#pragma once

#include "common/solid/settle_statistics.hpp"
#include "common/tree/query_statistics.hpp"

#include <cstdint>

namespace cd {

/// The cost of telling whether one body lies inside the other, or penetrates it without a proper
/// pair, apart from all else.
struct InsideStatistics {
    std::uint64_t scenarios = 0; ///< In which it was looked at.
    double seconds = 0;    ///< Of one thread, by the clock on the wall; see `Settler::settle`.
    SettleStatistics work; ///< What was looked at; stays on the machine that settled.

    InsideStatistics& operator+=(const InsideStatistics& other);
};

/// Summed over a job's scenarios.
struct JobStatistics {
    QueryStatistics search;
    InsideStatistics inside;

    JobStatistics& operator+=(const JobStatistics& other);
};

} // namespace cd
