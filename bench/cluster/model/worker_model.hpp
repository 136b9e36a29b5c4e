// The simulated worker: what it holds, asks for, may run and has answered, without a clock, a
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

/// A block is asked for once, and stays: the paper's clients never drop a subtree. But with a limit
/// of the cache, those that no scenario here waits for or runs with leave, the one unused longest
/// first. A scenario is ready when its blocks are here, and those that are ready run in the order
/// in which they became so.
class WorkerModel {
  public:
    /// The workload outlives the model.
    /// `cache_bytes`: of memory; 0: no limit.
    WorkerModel(WorkerId id, const Workload& workload, std::uint64_t cache_bytes = 0);

    [[nodiscard]] WorkerId id() const { return id_; }
    /// What to ask the master for, if anything.
    std::optional<BlocksWanted> take(const BatchSent& batch);
    void take(const Hinted& hint);
    /// The same, of what was hinted: when nothing is needed at once, and as the product's limits
    /// say.
    std::optional<BlocksWanted> ahead();
    GaveBack take(const AskedBack& asked);
    /// True: it runs here, and may stop.
    [[nodiscard]] bool take(const CalledOff& loser);
    /// Of the blocks, on a fast core.
    [[nodiscard]] double open_seconds(const BlocksSent& message) const;
    /// From now on these blocks are here; what to say of that. Those that were here already, or
    /// that nobody wants, are of no use.
    BlocksHeld opened(const BlocksSent& message);

    /// What left since it was asked last, if anything did.
    std::optional<BlocksEvicted> evicted();

    [[nodiscard]] bool has(const BlockId& block) const {
        return slots_[block.tree][block.root] == Slot::Here;
    }
    [[nodiscard]] std::size_t ready_count() const { return ready_.size(); }
    /// Of those that are ready the first, which is not ready any more.
    std::uint64_t next();
    /// The scenario has run, or was stopped, and took so long here.
    void ran(std::uint64_t scenario, double now, double seconds);
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
        double compute_seconds = 0; ///< Of the unsent ones.
        std::set<std::uint64_t> given_back;
    };
    struct Waiting {
        TaskId task;
        std::size_t missing = 0;
        bool has_begun = false;
        bool is_called_off = false;
    };

    /// It has not begun, and leaves its task.
    void drop(std::uint64_t scenario);

    void want(const BlockId& block, BlocksWanted& wanted);
    void pin(const BlockId& block);
    void unpin(const BlockId& block);
    void set_idle(const BlockId& block);
    void evict();

    WorkerId id_;
    const Workload& workload_;
    std::uint64_t cache_bytes_;
    // With a limit only:
    std::map<BlockId, std::uint32_t> pins_;            ///< Scenarios here that need it.
    std::set<std::pair<std::uint64_t, BlockId>> idle_; ///< Here and not pinned, by last use.
    std::map<BlockId, std::uint64_t> last_use_;        ///< Of the idle ones.
    std::uint64_t uses_ = 0;
    std::vector<BlockId> evicted_;

    std::array<std::vector<Slot>, 2> slots_;
    std::map<BlockId, std::vector<std::uint64_t>> waiting_for_; ///< Scenarios.
    std::map<std::uint64_t, Waiting> scenarios_;                ///< Not yet run.
    std::deque<std::uint64_t> ready_;
    std::map<TaskId, Task> tasks_;
    std::deque<BlockId> hinted_; ///< Not asked for.
    std::uint64_t memory_bytes_ = 0;
    std::uint64_t wanted_bytes_ = 0; ///< Of memory, when they will be here.
    std::uint64_t received_blocks_ = 0;
};

} // namespace cd::bench
