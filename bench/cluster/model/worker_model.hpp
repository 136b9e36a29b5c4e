// The simulated worker: its blocks, requests, runnable scenarios and answers, without a clock, a
// network or computation.
#pragma once

#include "bench/cluster/model/messages.hpp"
#include "bench/cluster/model/workload.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace cd::bench {

/// Requests each block once and keeps it: the paper's clients never drop a subtree. With a cache
/// limit, evicts blocks that no scenario waits for or uses, least recently used first. A scenario
/// is ready when its blocks are here; ready scenarios run in the order in which they became ready.
class WorkerModel {
  public:
    /// The workload must outlive the model. `cache_bytes`: limit of memory; 0: none.
    WorkerModel(WorkerId id, const Workload& workload, std::uint64_t cache_bytes = 0);

    [[nodiscard]] WorkerId id() const { return id_; }
    /// Returns the blocks to request from the master, if any.
    std::optional<BlocksWanted> take(const BatchSent& batch);
    void take(const Hinted& hint);
    /// Returns hinted blocks to request, when nothing is needed at once, within the product's
    /// limits.
    std::optional<BlocksWanted> ahead();
    GaveBack take(const AskedBack& asked);
    /// Returns true if the scenario runs here and may stop.
    [[nodiscard]] bool take(const CalledOff& loser);
    /// Returns the seconds to open the blocks on a fast core.
    [[nodiscard]] double open_seconds(const BlocksSent& message) const;
    /// Adds blocks, and returns the report to the master. Blocks already here, or wanted by no
    /// scenario, are dropped.
    BlocksHeld opened(const BlocksSent& message);

    /// Returns the blocks evicted since the last call, if any.
    std::optional<BlocksEvicted> evicted();

    [[nodiscard]] bool has(const BlockId& block) const {
        return slots_[block.tree][block.root] == Slot::Here;
    }
    [[nodiscard]] std::size_t ready_count() const { return ready_.size(); }
    /// Removes and returns the first ready scenario.
    std::uint64_t next();
    /// Notes that the scenario ran, or was stopped, after so many seconds.
    void ran(std::uint64_t scenario, double now, double seconds);
    /// Returns the results to send: all of ended tasks, and of other tasks those whose oldest
    /// result is at least `period` old.
    std::vector<ResultsSent> due(double now, double period);

    [[nodiscard]] std::uint64_t memory_bytes() const { return memory_bytes_; }
    [[nodiscard]] std::uint64_t received_blocks() const { return received_blocks_; }

  private:
    enum class Slot : std::uint8_t { Absent, Wanted, Here };
    struct Task {
        std::uint64_t open = 0; ///< Scenarios not yet run.
        std::vector<std::uint64_t> unsent;
        double unsent_since = 0;
        double compute_seconds = 0; ///< Time of the unsent results.
        std::set<std::uint64_t> given_back;
    };
    struct Waiting {
        TaskId task;
        std::size_t missing = 0;
        bool has_begun = false;
        bool is_called_off = false;
    };

    /// Removes a scenario that has not begun from its task.
    void drop(std::uint64_t scenario);

    void want(const BlockId& block, BlocksWanted& wanted);
    void pin(const BlockId& block);
    void unpin(const BlockId& block);
    void set_idle(const BlockId& block);
    void evict();

    WorkerId id_;
    const Workload& workload_;
    std::uint64_t cache_bytes_;
    // Used only with a cache limit:
    std::map<BlockId, std::uint32_t> pins_; ///< Number of scenarios here that need the block.
    std::set<std::pair<std::uint64_t, BlockId>> idle_; ///< Unpinned blocks here, by last use.
    std::map<BlockId, std::uint64_t> last_use_;        ///< Last use of the idle blocks.
    std::uint64_t uses_ = 0;
    std::vector<BlockId> evicted_;

    std::array<std::vector<Slot>, 2> slots_;
    /// Scenarios that wait for the block.
    std::map<BlockId, std::vector<std::uint64_t>> waiting_for_;
    std::map<std::uint64_t, Waiting> scenarios_; ///< Scenarios not yet run.
    std::deque<std::uint64_t> ready_;
    std::map<TaskId, Task> tasks_;
    std::deque<BlockId> hinted_; ///< Hinted blocks, not yet requested.
    std::uint64_t memory_bytes_ = 0;
    std::uint64_t wanted_bytes_ = 0; ///< Memory of the requested blocks once they arrive.
    std::uint64_t received_blocks_ = 0;
};

} // namespace cd::bench
