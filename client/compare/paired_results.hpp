// Reads the results of two runs side by side.
#pragma once

#include "client/compare/scenario_match.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/query.hpp"
#include "common/job/result/record_file.hpp"
#include "common/job/result/result.hpp"
#include "common/scene/step_index.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace cd {

/// True if a result says for every pair of triangles whether it is in contact.
[[nodiscard]] inline bool is_tested(const ScenarioResult* result) {
    return result != nullptr && result->kind != ScenarioClass::Failed &&
           result->kind != ScenarioClass::Undecided;
}

/// A scenario of one or of two runs, and its results. A null result is missing.
struct PairedResult {
    std::optional<std::uint64_t> earlier; ///< Index in the earlier run, if it is one of its.
    std::optional<std::uint64_t> later;   ///< Index in the later run, if it is one of its.
    const ScenarioResult* was = nullptr;  ///< Result in the earlier run.
    const ScenarioResult* is = nullptr;   ///< Result in the later run.

    /// True if both runs answer for the scenario: it is one of theirs, or follows from boxes.
    [[nodiscard]] bool is_in_both() const {
        return (earlier || was != nullptr) && (later || is != nullptr);
    }
    [[nodiscard]] bool is_comparable() const { return is_tested(was) && is_tested(is); }
};

/// The pairs of bodies that a scene has not tested at a step, since their boxes are apart.
class ApartPairs {
  public:
    /// `are_fixed` is by body. `has_rules_of_other` says that the run ignores no pair that the
    /// other one tests.
    ApartPairs(std::shared_ptr<const StepIndex> steps,
               std::vector<bool> are_fixed,
               const Query& query,
               bool has_rules_of_other);

    /// Returns the step of one of the run's scenarios.
    [[nodiscard]] std::uint64_t step_of(std::uint64_t scenario) const {
        return steps_->step_of(scenario);
    }
    /// Returns the result that follows for a pair which is no scenario of the run at this step:
    /// separate, in the place of a record. Nothing if the run may have left the pair out for
    /// another reason: it has fewer steps, a body may be absent, the rules may ignore the pair, or
    /// both bodies are fixed and step 0 has decided.
    [[nodiscard]] std::optional<ScenarioResult>
    result_of(std::uint64_t step, std::uint32_t body_a, std::uint32_t body_b) const;

  private:
    std::shared_ptr<const StepIndex> steps_;
    std::vector<bool> are_fixed_;
    ScenarioResult separate_; ///< Without step and bodies.
    bool has_rules_of_other_;
};

/// A run whose results are read.
struct ReadRun {
    RecordFile& records;
    std::uint64_t scenarios = 0;
    const ApartPairs* apart = nullptr; ///< Of scenes that are matched by step and bodies.
};

/// Calls `take` with each scenario of the later run, in order, and then with each scenario that
/// only the earlier run has, in its order. Where both runs have `ReadRun::apart`, a scenario of one
/// run alone has the result of the other that follows from boxes. Reads each block of records once,
/// unless the runs have matched scenarios in another order. Memory: a bit for each scenario of the
/// earlier run. Errors: Io; of `take`; Interrupted.
[[nodiscard]] Status for_each_pair(const ReadRun& earlier,
                                   const ReadRun& later,
                                   const ScenarioMatch& match,
                                   const StopCheck& stop,
                                   const std::function<Status(const PairedResult&)>& take);

} // namespace cd
