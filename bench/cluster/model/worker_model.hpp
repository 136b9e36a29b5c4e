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
/// A range waits until both upper trees are here, which are never evicted.
class WorkerModel {
  public:
    /// The workload must outlive the model. `cache_bytes`: limit of memory; 0: none.
    WorkerModel(WorkerId id, const Workload& workload, std::uint64_t cache_bytes = 0);
    /// Runs scenarios one after the other, and requests the blocks of each when its turn comes, as
    /// in the paper's section 5.1. Call before the first scenario.
    void take_turns() { takes_turns_ = true; }

    [[nodiscard]] WorkerId id() const { return id_; }
    /// Returns the requests for blocks.
    Messages take(const WorkUnit& unit);
    /// Returns the requests for the blocks of the next scenario, if scenarios take turns and no
    /// scenario is under way.
    Messages proceed();
    void take(const Hint& hint);
    /// Returns requests for hinted blocks, when nothing is needed at once, within the product's
    /// limits.
    Messages ahead();
    /// Returns all returned scenarios of the task; nothing for a task that has ended, as a worker
    /// does. Returns no scenario of a range that waits for the upper trees.
    std::optional<Recalled> take(const Recall& recall);
    /// Returns true if the scenario runs here and may stop.
    [[nodiscard]] bool take(const DropScenario& loser);
    /// Returns the seconds to open the blocks on a fast core.
    [[nodiscard]] double open_seconds(const Subtrees& blocks) const;
    /// Adds blocks, and returns the reports to the master. Blocks already here, or wanted by no
    /// scenario, are dropped.
    Messages opened(const Subtrees& blocks);

    /// Reports the blocks evicted since the last call.
    Messages evicted() { return by_tree<Evicted>(std::exchange(evicted_, {})); }

    [[nodiscard]] bool has(const BlockId& block) const { return slot(block) == Slot::Here; }
    [[nodiscard]] std::size_t ready_count() const { return ready_.size(); }
    /// Removes and returns the first ready scenario.
    std::uint64_t next();
    /// Notes that the scenario ran, or was stopped, after so many seconds.
    void ran(std::uint64_t scenario, double now, double seconds);
    /// Returns the results to send: all of ended tasks, and of other tasks those whose oldest
    /// result is at least `period` old. Reports the end of ended tasks.
    Messages due(double now, double period);
    /// True if results wait for `due`.
    [[nodiscard]] bool has_unsent() const;
    /// Time for which the master lets results wait, in seconds: that of the last unit.
    [[nodiscard]] double results_wait() const { return results_wait_; }

    [[nodiscard]] std::uint64_t memory_bytes() const { return memory_bytes_; }
    [[nodiscard]] std::uint64_t received_blocks() const { return received_blocks_; }
    /// Number of blocks that came although they were here.
    [[nodiscard]] std::uint64_t blocks_again() const { return blocks_again_; }

  private:
    enum class Slot : std::uint8_t { Absent, Wanted, Here };
    struct Task {
        JobId job;
        std::uint64_t open = 0;  ///< Scenarios not yet run.
        std::uint64_t first = 0; ///< Of a range.
        std::uint64_t count = 0;
        bool is_range = false;
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

    /// Of the upper tree if the root is `top_root`.
    [[nodiscard]] const Slot& slot(const BlockId& block) const {
        const auto& slots = slots_[block.tree];
        return block.root == top_root ? slots.back() : slots[block.root];
    }
    [[nodiscard]] Slot& slot(const BlockId& block) {
        return const_cast<Slot&>(std::as_const(*this).slot(block)); // NOLINT: the same in both.
    }
    /// Adds the scenarios of the unit, and returns the blocks to request.
    std::vector<BlockId> begin(const WorkUnit& unit);
    /// Adds a scenario, and the blocks to request for it.
    void admit(std::uint64_t scenario, TaskId task, std::vector<BlockId>& wanted);
    /// Removes a scenario that has not begun from its task.
    void drop(std::uint64_t scenario);

    void want(const BlockId& block, std::vector<BlockId>& wanted);
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

    std::array<std::vector<Slot>, 2> slots_; ///< By root; the last is the upper tree's.
    /// Scenarios that wait for the block.
    std::map<BlockId, std::vector<std::uint64_t>> waiting_for_;
    std::map<std::uint64_t, Waiting> scenarios_; ///< Scenarios not yet run.
    std::deque<std::uint64_t> ready_;
    bool takes_turns_ = false;
    std::deque<std::pair<std::uint64_t, TaskId>> turns_; ///< Scenarios whose turn is to come.
    std::vector<WorkUnit> ranges_;                       ///< Ranges that wait for the upper trees.
    std::map<TaskId, Task> tasks_;
    double results_wait_ = 0;
    std::deque<BlockId> hinted_; ///< Hinted blocks, not yet requested.
    std::uint64_t memory_bytes_ = 0;
    std::uint64_t wanted_bytes_ = 0; ///< Memory of the requested blocks once they arrive.
    std::uint64_t received_blocks_ = 0;
    std::uint64_t blocks_again_ = 0;
    std::uint64_t sequence_ = 0; ///< Number of the last message of results.
};

} // namespace cd::bench
