// All workers known to the master (the paper's "client manager", section 6.4.1).
#pragma once

#include "common/tree/root_holders.hpp"
#include "master/dispatch/dispatch_tree.hpp"
#include "master/dispatch/workers/worker_proxy.hpp"

#include <map>
#include <span>
#include <vector>

namespace cd {

/// A tree, and for each distribution root the workers that hold it, by their proxies' slots.
struct PooledTree {
    /// Roots that a worker holds, or soon will because it got a scenario with them (paper, 5.1 and
    /// 6.4.5).
    RootHolders held;
    /// The part of `held` whose blocks may still be under way.
    RootHolders coming;
    std::vector<std::uint32_t> triangles; ///< Number of triangles below each root.
    std::vector<std::uint32_t> bytes_64;  ///< Wire size of each root's block, in units of 64 bytes.
    std::uint64_t triangles_total = 0;
    std::uint64_t bytes_total = 0;

    /// Wire size of the root's block, rounded up.
    [[nodiscard]] std::uint64_t bytes_of(RootIndex root) const {
        return bytes_unit * bytes_64[root];
    }
    static constexpr std::uint64_t bytes_unit = 64;
};

/// The workers' proxies in ascending order of id, and the roots that each worker holds.
class WorkerPool {
  public:
    /// The id must be new.
    WorkerProxy& add(WorkerId worker, const WorkerFacts& facts);
    /// The worker must exist.
    void remove(WorkerId worker);

    /// Null if there is no such worker.
    [[nodiscard]] WorkerProxy* find(WorkerId worker);
    [[nodiscard]] const WorkerProxy* find(WorkerId worker) const;
    /// The worker must exist.
    [[nodiscard]] WorkerProxy& at(WorkerId worker);

    [[nodiscard]] std::map<WorkerId, WorkerProxy>& all() { return proxies_; }
    [[nodiscard]] const std::map<WorkerId, WorkerProxy>& all() const { return proxies_; }
    /// All proxies, ascending by id; faster to iterate than `all`.
    [[nodiscard]] std::span<WorkerProxy* const> in_order() const { return in_order_; }
    /// The first worker that takes work. Null if none does.
    [[nodiscard]] const WorkerProxy* first_that_takes_work() const;

    // ---- Held blocks --------------------------------------------------------------------------
    /// Ignored if the tree exists.
    void add_tree(const DispatchTree& tree);
    void remove_tree(TreeId tree);
    /// The tree must have been added.
    [[nodiscard]] const PooledTree& tree(TreeId tree) const;

    /// Blocks that must be transferred.
    struct Missing {
        std::vector<RootIndex> roots; ///< In the order requested.
        std::uint64_t bytes = 0;
    };
    /// Marks the roots as held by the worker. Returns those that it did not hold; they are marked
    /// as coming.
    Missing hold(WorkerProxy& proxy, TreeId tree, std::span<const WeightedRoot> roots);
    Missing hold(WorkerProxy& proxy, TreeId tree, std::span<const RootIndex> roots);
    /// Marks blocks as arrived. Ignores unknown trees and roots out of range.
    void arrived(const WorkerProxy& proxy, TreeId tree, std::span<const RootIndex> roots);
    void arrived(const WorkerProxy& proxy, TreeId tree, std::span<const WeightedRoot> roots);
    /// The worker no longer holds these roots. Ignores unknown trees and roots out of range.
    void release(WorkerProxy& proxy, TreeId tree, std::span<const RootIndex> roots);

    /// Aborts unless slots are unique, free slots hold nothing, expected roots count as held, and
    /// all counters are right.
    void check() const;

  private:
    /// Lowest free slot; adds one if all are taken.
    [[nodiscard]] std::uint32_t free_slot();
    static void hold_root(WorkerProxy& proxy, PooledTree& tree, RootIndex root, Missing& missing);
    void check_tree(const PooledTree& tree) const;

    std::map<WorkerId, WorkerProxy> proxies_;
    std::vector<WorkerProxy*> in_order_;
    std::map<TreeId, PooledTree> trees_;
    std::vector<bool> slot_taken_;
};

} // namespace cd
