// Size of a worker's batches and ranges, for matching by time and for ranges.
#pragma once

#include "common/core/timing/master.hpp"
#include "master/dispatch/workers/worker_tasks.hpp"

#include <cstdint>

namespace cd {

/// Adapts the size so that a worker loses little time between two batches.
class BatchSize {
  public:
    /// Target duration of a batch or range while much work is left, s.
    [[nodiscard]] double seconds() const { return seconds_; }
    /// Batch size in predicted time; only `set` changes it.
    [[nodiscard]] std::uint64_t cost_ns() const { return cost_ns_; }
    /// True if scenarios take so long that a round trip is negligible; only `set` changes it.
    [[nodiscard]] bool are_long() const { return are_long_; }
    void set(std::uint64_t cost_ns, bool are_long) {
        cost_ns_ = cost_ns;
        are_long_ = are_long;
    }
    /// Lengthens batches if the worker's threads idled too long during the ended task. Ignores a
    /// task that waited for blocks, or that was the worker's last one. `now` in s.
    void judge(const TaskInFlight& ended, bool has_successor, double threads, double now);

  private:
    double seconds_ = timing::batch_seconds_start;
    std::uint64_t cost_ns_ = 0;
    bool are_long_ = false;
    double task_ended_ = 0; ///< End of the last task, s.
};

} // namespace cd
