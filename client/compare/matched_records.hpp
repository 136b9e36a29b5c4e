// Reads the results of an earlier run in the order of a later run.
#pragma once

#include "client/compare/scenario_match.hpp"
#include "common/core/files/bytes.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/result.hpp"
#include "common/job/result/record_file.hpp"
#include "common/job/result/result.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace cd {

/// Finds the earlier run's results of matched scenarios. Calls in ascending order of the later run
/// read each block of records once, if the earlier run has the scenarios in the same order. In any
/// other order, the records of a window of scenarios are read ahead, so that each block is read at
/// most once for each window.
class MatchedRecords {
  public:
    /// `records` and `match` must outlive the object. `scenarios` is the later run's number of
    /// scenarios. Records read ahead have at most `ahead_bytes_max` bytes, unless a single one has
    /// more.
    MatchedRecords(RecordFile& records,
                   const ScenarioMatch& match,
                   std::uint64_t scenarios,
                   std::uint64_t ahead_bytes_max = limits::compared_ahead_bytes_max)
        : records_(records),
          match_(match),
          scenarios_(scenarios),
          ahead_bytes_max_(ahead_bytes_max) {}

    /// Returns the earlier run's result of a scenario of the later run, with the earlier run's
    /// index; null if the scenario has no match or the match has no result. The pointer is valid
    /// until the next call. Errors: Io naming the file.
    [[nodiscard]] Result<const ScenarioResult*> of(std::uint64_t index);

  private:
    [[nodiscard]] Status begin_window(std::uint64_t first);
    [[nodiscard]] Status read_ahead(std::vector<std::array<std::uint64_t, 2>> wanted);
    [[nodiscard]] std::uint64_t halve_window();

    RecordFile& records_;
    const ScenarioMatch& match_;
    std::uint64_t scenarios_;
    std::uint64_t ahead_bytes_max_;
    std::uint64_t window_begin_ = 0; ///< The first scenario of the window.
    std::uint64_t window_end_ = 0;   ///< The window ends before this scenario.
    /// For each scenario of the window its record, which is empty if there is none; empty if the
    /// scenarios of the window come in the earlier run's order.
    std::vector<Bytes> ahead_;
    ScenarioResult found_; ///< What the last call found in `ahead_`.
};

} // namespace cd
