// How much work a worker gets at once, in matching by time and in ranges.
#pragma once

#include "common/core/limits/master.hpp"
#include "master/dispatch/workers/worker_tasks.hpp"

#include <cstdint>

namespace cd {

/// Batches last so long that little of a worker's time passes between them.
class BatchSize {
  public:
    /// Target duration of a batch while much work is left.
    [[nodiscard]] double seconds() const { return seconds_; }
    /// Batch size in predicted time; changes only by `set`.
    [[nodiscard]] std::uint64_t cost_ns() const { return cost_ns_; }
    /// The scenarios are so long that a round trip is negligible; changes only by `set`.
    [[nodiscard]] bool are_long() const { return are_long_; }
    void set(std::uint64_t cost_ns, bool are_long) {
        cost_ns_ = cost_ns;
        are_long_ = are_long;
    }
    /// Lengthens batches if this ended one had too much overhead on the worker's threads. Ignores
    /// batches without a successor, and those that waited for blocks. Times in s.
    void judge(const TaskInFlight& ended, bool has_successor, double threads, double now);

  private:
    double seconds_ = limits::batch_seconds_start;
    std::uint64_t cost_ns_ = 0;
    bool are_long_ = false;
    double task_ended_ = 0; ///< End of the last task, s.
};

} // namespace cd
