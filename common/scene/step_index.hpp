// To which step of a scene each scenario belongs.
#pragma once

#include <cstdint>
#include <vector>

namespace cd {

/// The scenarios of a scene's steps: those of a step are consecutive, and follow those of the step
/// before. Memory: 8 bytes a step, and 8 for its time.
class StepIndex {
  public:
    /// Appends a step with so many scenarios, which may be none.
    void add_step(std::uint64_t scenarios) { ends_.push_back(count() + scenarios); }
    /// Sets the time of each step, in the unit of the user's file. Empty: the times are 0, 1, 2,
    /// ...
    void set_times(std::vector<double> times);

    [[nodiscard]] std::uint64_t steps() const { return ends_.size(); }
    /// Number of the scenarios of all steps.
    [[nodiscard]] std::uint64_t count() const { return ends_.empty() ? 0 : ends_.back(); }
    /// Returns the first scenario of a step, which must exist.
    [[nodiscard]] std::uint64_t first_of(std::uint64_t step) const;
    /// Returns one past the last scenario of a step, which must exist.
    [[nodiscard]] std::uint64_t end_of(std::uint64_t step) const;
    /// Returns the step of a scenario, which must exist.
    [[nodiscard]] std::uint64_t step_of(std::uint64_t scenario) const;
    /// Returns the time of a step, which must exist.
    [[nodiscard]] double time_of(std::uint64_t step) const;

  private:
    std::vector<std::uint64_t> ends_;
    std::vector<double> times_;
};

} // namespace cd
