// Measurements of a running job: the speed of ranges, the cost of missing blocks, and the work
// that was done twice.
#pragma once

#include "common/core/id.hpp"
#include "master/dispatch/range_choice.hpp"
#include "master/dispatch/worker_pace.hpp"

#include <cstdint>
#include <map>

namespace cd {

/// Range scenarios per second and thread, of each worker and of all.
class RangePace {
  public:
    void add(WorkerId worker, std::uint64_t scenarios, double seconds);
    void forget(WorkerId worker) { of_workers_.erase(worker); }
    /// The worker's rate; unmeasured, that of all; unmeasured, `otherwise`.
    [[nodiscard]] double per_thread(WorkerId worker, double otherwise) const;

  private:
    LearnedRate general_;
    std::map<WorkerId, LearnedRate> of_workers_;
};

/// Seconds to fetch and open the blocks that scenarios miss, at the worker that matched them and at
/// any worker.
class MissingMeter {
  public:
    /// True for the first of every 16 scenarios that get a worker: call `add_sample` then.
    [[nodiscard]] bool is_sampled() { return held_++ % period == 0; }
    /// `seconds_any`: what the scenario misses at an average worker.
    void add_sample(double seconds_any);
    /// Adds the time to fetch the blocks that a scenario misses at its worker.
    void add_matched(double seconds) { seconds_ += seconds; }
    /// Adds the time to fetch the blocks that a worker misses for its ranges.
    void add_in_ranges(double seconds) { in_ranges_ += seconds; }
    void ranges_answered(std::uint64_t scenarios);
    /// Seconds per scenario on any worker.
    [[nodiscard]] double any_or(double otherwise) const { return any_.value_or(otherwise); }
    /// Sets both costs, if both are known.
    void tell(MissingCosts& costs) const;

  private:
    static constexpr std::uint64_t period = 16;

    LearnedRate matched_;    ///< Seconds per scenario.
    LearnedRate any_;        ///< Seconds per scenario.
    std::uint64_t held_ = 0; ///< Scenarios that got a worker.
    double seconds_ = 0;     ///< Of the matched scenarios not yet averaged.
    double in_ranges_ = 0;   ///< Of ranges since the last answers.
};

/// Bounds the share of a job's work that is copied, in predicted time.
class CopyBudget {
  public:
    /// Work was received or sent.
    void add_work(std::uint64_t cost_ns) { work_ns_ += cost_ns; }
    /// Work will be sent again.
    void remove_work(std::uint64_t cost_ns);
    void add_copy(std::uint64_t cost_ns) { copied_ns_ += cost_ns; }
    /// Predicted time of the work that may still be copied.
    [[nodiscard]] std::uint64_t left_ns() const;

  private:
    std::uint64_t work_ns_ = 0;
    std::uint64_t copied_ns_ = 0; ///< Work ever copied.
};

} // namespace cd
