// The simulated worker: what it holds, asks for, may run and has answered, without a clock, a
// network or computation.
#pragma once

#include "bench/cluster/messages.hpp"
#include "bench/cluster/workload.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

namespace cd::bench {

/// Nothing that came leaves: the paper's clients never drop a subtree. A block is asked
/// for once; a scenario is ready when its blocks are here, and those that are ready run in the
/// order in which they became so.
class WorkerModel {
  public:
    /// The workload outlives the model.
    WorkerModel(WorkerId id, const Workload& workload);

    /// What to ask the master for, if anything.
    std::optional<BlocksWanted> take(const BatchSent& batch);
    /// Of the blocks, on a fast core.
    [[nodiscard]] double open_seconds(const BlocksSent& message) const;
    /// From now on these blocks are here.
    void opened(const BlocksSent& message);

    [[nodiscard]] std::size_t ready_count() const { return ready_.size(); }
    /// Of those that are ready the first, which is not ready any more.
    std::uint64_t next();
    /// The scenario has run.
    void ran(std::uint64_t scenario, double now);
    /// The results to be sent: all of tasks that ended, and of the others those whose oldest is as
    /// old as `period`.
    std::vector<ResultsSent> due(double now, double period);

    [[nodiscard]] std::uint64_t memory_bytes() const { return memory_bytes_; }
    [[nodiscard]] std::uint64_t received_blocks() const { return received_blocks_; }

  private:
    enum class Slot : std::uint8_t { Absent, Wanted, Here };
    struct Task {
        std::uint64_t open = 0; ///< Not yet run.
        std::vector<std::uint64_t> unsent;
        double unsent_since = 0;
    };
    struct Waiting {
        TaskId task;
        std::size_t missing = 0;
    };

    WorkerId id_;
    const Workload& workload_;
    std::array<std::vector<Slot>, 2> slots_;
    std::map<BlockId, std::vector<std::uint64_t>> waiting_for_; ///< Scenarios.
    std::map<std::uint64_t, Waiting> scenarios_;                ///< Not yet run.
    std::deque<std::uint64_t> ready_;
    std::map<TaskId, Task> tasks_;
    std::uint64_t memory_bytes_ = 0;
    std::uint64_t received_blocks_ = 0;
};

} // namespace cd::bench
