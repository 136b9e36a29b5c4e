// The steps of a scene: which scenarios belong to each, and what became of all pairs of bodies.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cd {

/// What became of the pairs of bodies of a step. Each pair counts once.
struct StepCoverage {
    std::uint64_t tested = 0;  ///< Their boxes come within reach: the step's scenarios.
    std::uint64_t apart = 0;   ///< Their boxes show that they are farther apart than the reach.
    std::uint64_t ignored = 0; ///< Both are present, and the rules ignore the pair.
    std::uint64_t fixed = 0;   ///< Both are fixed and not ignored; step 0 has decided the pair.
    std::uint64_t absent = 0;  ///< One of them is absent.

    [[nodiscard]] std::uint64_t total() const { return tested + apart + ignored + fixed + absent; }
    StepCoverage& operator+=(const StepCoverage& other);
    friend bool operator==(const StepCoverage&, const StepCoverage&) = default;
};

/// The steps of a scene. The scenarios of a step are consecutive, and follow those of the step
/// before. Memory: some 60 bytes a step.
class StepIndex {
  public:
    /// Appends a step. It has as many scenarios as pairs that are tested, which may be none.
    void add_step(const StepCoverage& coverage);
    /// Sets the time of each step, in the unit of the user's file, and of motions also that of the
    /// last one's end. Empty: the times are 0, 1, 2, ...
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
    /// Returns the time at `tau` in [0, 1] of a step that is a motion; its end is the begin of the
    /// next.
    [[nodiscard]] double time_at(std::uint64_t step, double tau) const;
    /// Returns the times as they were set.
    [[nodiscard]] std::span<const double> times() const { return times_; }
    /// Returns what became of the pairs of each step.
    [[nodiscard]] std::span<const StepCoverage> coverage() const { return coverage_; }

  private:
    std::vector<std::uint64_t> ends_;
    std::vector<StepCoverage> coverage_;
    std::vector<double> times_;
};

/// Packs the steps, compressed: version (u8, 1), their number and which times they have (u8: 0
/// none, 1 that of each step, 2 also that of the last one's end); for each step the five numbers of
/// `StepCoverage` in their order; then the times (f64). Integers are varints (varint.hpp) unless
/// marked u8.
[[nodiscard]] Bytes pack_steps(const StepIndex& steps);

/// Unpacks the bytes of `pack_steps`, which are untrusted. Errors: BadFrame, also for other than
/// `scenarios` scenarios, and for times that are not finite.
[[nodiscard]] Result<std::shared_ptr<const StepIndex>>
unpack_steps(std::span<const std::byte> bytes, std::uint64_t scenarios);

} // namespace cd
