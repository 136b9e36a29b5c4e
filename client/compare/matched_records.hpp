// Reads the results of an earlier run in the order of a later run.
#pragma once

#include "client/compare/scenario_match.hpp"
#include "common/core/result.hpp"
#include "common/job/result/record_file.hpp"
#include "common/job/result/result.hpp"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace cd {

/// Finds the earlier run's results of matched scenarios. Calls in ascending order of the later run
/// read each block of records once, if the earlier run has the scenarios in the same order. For any
/// other order, the results of some thousand scenarios are read ahead, in bounded memory.
class MatchedRecords {
  public:
    /// Both must outlive the object. `scenarios` is the later run's number of scenarios.
    MatchedRecords(RecordFile& records, const ScenarioMatch& match, std::uint64_t scenarios)
        : records_(records), match_(match), scenarios_(scenarios) {}

    /// Returns the earlier run's result of a scenario of the later run, with the earlier run's
    /// index; null if the scenario has no match or the match has no result. The pointer is valid
    /// until the next call. Errors: Io naming the file.
    [[nodiscard]] Result<const ScenarioResult*> of(std::uint64_t index);

  private:
    [[nodiscard]] Status read_ahead(std::uint64_t first);

    RecordFile& records_;
    const ScenarioMatch& match_;
    std::uint64_t scenarios_;
    std::uint64_t ahead_end_ = 0; ///< What is read ahead ends before this scenario.
    std::map<std::uint64_t, ScenarioResult> ahead_; ///< By the earlier run's index.
};

} // namespace cd
