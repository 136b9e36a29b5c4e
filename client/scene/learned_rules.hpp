// The pairs of bodies in contact at a step, as rules that users may paste into their job.
#pragma once

#include "common/job/result/result.hpp"
#include "common/scene/step_index.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cd {

/// Returns a pattern that names this body and no other: characters with a meaning are escaped.
[[nodiscard]] std::string pattern_of(const std::string& body);

/// Collects the pairs of bodies that are in contact at one step. It never applies them.
class LearnedRules {
  public:
    LearnedRules(std::shared_ptr<const StepIndex> steps,
                 std::uint64_t step,
                 std::vector<std::string> bodies);

    void add(const ScenarioResult& result);
    /// Returns a rule for each pair, a line each, to paste into [rules] order; empty without pairs.
    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] std::uint64_t step() const { return step_; }

  private:
    std::shared_ptr<const StepIndex> steps_;
    std::uint64_t step_;
    std::vector<std::string> bodies_; ///< Their names.
    std::string text_;
};

} // namespace cd
