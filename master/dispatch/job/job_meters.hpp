// Measurements of a running job: the speed of ranges, the cost of missing blocks, and the amount of
// copied work.
#pragma once

#include "common/core/id.hpp"
#include "master/dispatch/range_choice.hpp"
#include "master/dispatch/worker_pace.hpp"

#include <cstdint>
#include <optional>
#include <unordered_map>

namespace cd {

/// Scenarios of ranges that one thread finishes per second, for each worker and over all workers.
class RangePace {
  public:
    void add(WorkerId worker, std::uint64_t scenarios, double seconds);
    void forget(WorkerId worker) { of_workers_.erase(worker); }
    /// Returns the worker's rate if known, else the rate over all workers if known, else
    /// `otherwise`.
    [[nodiscard]] double per_thread(WorkerId worker, double otherwise) const;

  private:
    LearnedRate general_;
    std::unordered_map<WorkerId, LearnedRate> of_workers_;
};

/// A weighted average over scenarios: recent ones count more. Unlike `LearnedRate`, it counts
/// zeros.
class ScenarioAverage {
  public:
    /// Adds `scenarios` scenarios, whose values have this sum.
    void add(double sum, double scenarios);
    [[nodiscard]] std::optional<double> value() const;

  private:
    double sum_ = 0;
    double scenarios_ = 0;
};

/// Seconds per scenario to fetch and open its missing blocks, at the worker chosen by matching and
/// at an average worker.
class MissingMeter {
  public:
    /// Counts a scenario that gets a worker. True for one in 16: call `add_sample` then.
    [[nodiscard]] bool is_sampled() { return held_++ % period == 0; }
    /// `seconds_any`: time to fetch the blocks that an average worker misses for the scenario.
    void add_sample(double seconds_any);
    /// Adds the time to fetch the blocks that a scenario misses at its worker.
    void add_matched(double seconds) { seconds_ += seconds; }
    /// Adds the time to fetch the blocks that a worker misses for its ranges.
    void add_in_ranges(double seconds) { in_ranges_ += seconds; }
    /// Divides the time added by `add_in_ranges` by the scenarios that these ranges answered.
    void ranges_answered(std::uint64_t scenarios);
    /// Seconds per scenario at an average worker.
    [[nodiscard]] double any_or(double otherwise) const { return any_.value().value_or(otherwise); }
    /// Sets `matched` and `any` of the costs, if both are known.
    void tell(MissingCosts& costs) const;

  private:
    static constexpr std::uint64_t period = 16;

    ScenarioAverage matched_; ///< Seconds, at the chosen worker.
    ScenarioAverage any_;     ///< Seconds, at an average worker.
    std::uint64_t held_ = 0;  ///< Number of calls of `is_sampled`.
    double seconds_ = 0;      ///< Sum of `add_matched` since the last sample.
    double in_ranges_ = 0;    ///< Sum of `add_in_ranges` since the last answers of a range.
};

/// Bounds the share of a job's work that gets speculative copies, in predicted time.
class CopyBudget {
  public:
    /// Adds the predicted time of an analysed scenario or of a sent range.
    void add_work(std::uint64_t cost_ns) { work_ns_ += cost_ns; }
    /// Subtracts the predicted time of positions of a range that will be sent again.
    void remove_work(std::uint64_t cost_ns);
    void add_copy(std::uint64_t cost_ns) { copied_ns_ += cost_ns; }
    /// Predicted time of the work that may still be copied.
    [[nodiscard]] std::uint64_t left_ns() const;

  private:
    std::uint64_t work_ns_ = 0;
    std::uint64_t copied_ns_ = 0; ///< Predicted time of all copies so far.
};

} // namespace cd
