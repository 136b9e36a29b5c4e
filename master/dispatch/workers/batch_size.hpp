// Size of a worker's batches and ranges, for matching by time and for ranges.
#pragma once

#include "common/core/timing/master.hpp"
#include "master/dispatch/workers/worker_tasks.hpp"

#include <cstdint>
#include <limits>

namespace cd {

/// Adapts the size so that a worker loses little time between two batches.
class BatchSize {
  public:
    /// Target duration of a batch or range while much work is left, s.
    [[nodiscard]] double seconds() const { return seconds_; }
    /// Shortest useful duration of a batch or range, s: the worker would be done with a shorter one
    /// before the next one could come. At most `timing::batch_seconds_start`.
    [[nodiscard]] double seconds_least() const;
    /// Batch size in predicted time; only `set` changes it.
    [[nodiscard]] std::uint64_t cost_ns() const { return cost_ns_; }
    /// True if scenarios take so long that a round trip is negligible; only `set` changes it.
    [[nodiscard]] bool are_long() const { return are_long_; }
    void set(std::uint64_t cost_ns, bool are_long) {
        cost_ns_ = cost_ns;
        are_long_ = are_long;
    }
    /// Notes that the worker asked for blocks or got some. `now` in s.
    void note_blocks(double now) { blocks_noted_ = now; }
    /// Measures the round trip if the worker was idle when the ended task came and no blocks were
    /// noted since. Lengthens batches if its threads idled too long, unless the task was its last
    /// one or is known to have waited for blocks. `now` in s.
    void judge(const TaskInFlight& ended, bool has_successor, double threads, double now);

  private:
    double seconds_ = timing::batch_seconds_start;
    std::uint64_t cost_ns_ = 0;
    bool are_long_ = false;
    double task_ended_ = 0;    ///< End of the last task, s.
    double blocks_noted_ = -1; ///< Time of the last `note_blocks`, s.
    /// Least time that a task took beyond its work, from its sending to the news of its end, s;
    /// infinite until measured.
    double round_trip_ = std::numeric_limits<double>::infinity();
};

} // namespace cd
