// Statistics of a job's cost. They are never part of a result or of the digest.
#pragma once

#include "common/solid/settle_statistics.hpp"
#include "common/tree/query_statistics.hpp"

#include <cstdint>

namespace cd {

/// The cost of deciding whether one body lies inside the other body, or penetrates it without a
/// proper pair. The cost of the contact search is not included.
struct InsideStatistics {
    std::uint64_t scenarios = 0; ///< Number of scenarios that took such a decision.
    double seconds = 0;    ///< Wall-clock time of one thread, in seconds; see `Settler::settle`.
    SettleStatistics work; ///< Counts of tests; never sent to another machine.

    InsideStatistics& operator+=(const InsideStatistics& other) {
        scenarios += other.scenarios;
        seconds += other.seconds;
        work += other.work;
        return *this;
    }
};

/// Sums of the statistics of a job's scenarios.
struct JobStatistics {
    QueryStatistics search;
    InsideStatistics inside;

    JobStatistics& operator+=(const JobStatistics& other) {
        search += other.search;
        inside += other.inside;
        return *this;
    }
};

} // namespace cd
