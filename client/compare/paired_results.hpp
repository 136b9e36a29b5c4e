// Reads the results of two runs side by side.
#pragma once

#include "client/compare/scenario_match.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/result/record_file.hpp"
#include "common/job/result/result.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace cd {

/// True if a result says for every pair of triangles whether it is in contact.
[[nodiscard]] inline bool is_tested(const ScenarioResult* result) {
    return result != nullptr && result->kind != ScenarioClass::Failed &&
           result->kind != ScenarioClass::Undecided;
}

/// A scenario of one or of two runs, and its results. A null result is missing.
struct PairedResult {
    std::optional<std::uint64_t> earlier; ///< Index in the earlier run.
    std::optional<std::uint64_t> later;   ///< Index in the later run.
    const ScenarioResult* was = nullptr;  ///< Result in the earlier run.
    const ScenarioResult* is = nullptr;   ///< Result in the later run.

    [[nodiscard]] bool is_in_both() const { return earlier && later; }
    [[nodiscard]] bool is_comparable() const { return is_tested(was) && is_tested(is); }
};

/// A run whose results are read.
struct ReadRun {
    RecordFile& records;
    std::uint64_t scenarios = 0;
};

/// Calls `take` with each scenario of the later run, in order, and then with each scenario that
/// only the earlier run has, in its order. Reads each block of records once, unless the runs have
/// matched scenarios in another order. Memory: a bit for each scenario of the earlier run. Errors:
/// Io; of `take`; Interrupted.
[[nodiscard]] Status for_each_pair(const ReadRun& earlier,
                                   const ReadRun& later,
                                   const ScenarioMatch& match,
                                   const StopCheck& stop,
                                   const std::function<Status(const PairedResult&)>& take);

} // namespace cd
