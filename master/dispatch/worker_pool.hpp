// All workers that the master knows (the paper's "client manager", section 6.4.1).
#pragma once

#include "common/tree/root_holders.hpp"
#include "master/dispatch/dispatch_tree.hpp"
#include "master/dispatch/worker_proxy.hpp"

#include <map>
#include <span>
#include <vector>

namespace cd {

/// A tree, and who holds what of it. Workers are slots of their proxies.
struct PooledTree {
    /// The roots that a worker holds or was allocated (paper, 5.1 and 6.4.5).
    RootHolders held;
    /// Of those the ones whose blocks may still be on their way.
    RootHolders coming;
    std::vector<std::uint32_t> triangles; ///< Of each root,
    std::vector<std::uint32_t> bytes_64;  ///< and its block's bytes as it travels, in units of 64.
    std::uint64_t triangles_total = 0;
    std::uint64_t bytes_total = 0;
};

/// Proxies in ascending order of id, and what they hold of each tree.
class WorkerPool {
  public:
    /// The id is new.
    WorkerProxy& add(WorkerId worker, const WorkerFacts& facts);
    /// The worker is here.
    void remove(WorkerId worker);

    /// Null where there is none.
    [[nodiscard]] WorkerProxy* find(WorkerId worker);
    [[nodiscard]] const WorkerProxy* find(WorkerId worker) const;
    /// The worker is here.
    [[nodiscard]] WorkerProxy& at(WorkerId worker);

    [[nodiscard]] std::map<WorkerId, WorkerProxy>& all() { return proxies_; }
    [[nodiscard]] const std::map<WorkerId, WorkerProxy>& all() const { return proxies_; }
    /// The same, quicker to walk.
    [[nodiscard]] std::span<WorkerProxy* const> in_order() const { return in_order_; }

    // ---- What they hold -----------------------------------------------------------------------
    /// Nothing for a tree that is here.
    void add_tree(const DispatchTree& tree);
    void remove_tree(TreeId tree);
    /// The tree has been added.
    [[nodiscard]] const PooledTree& tree(TreeId tree) const;

    /// Blocks that have to travel.
    struct Missing {
        std::vector<RootIndex> roots; ///< In the order asked.
        std::uint64_t bytes = 0;
    };
    /// From now on the worker holds these; what it did not hold is coming.
    Missing hold(WorkerProxy& proxy, TreeId tree, std::span<const WeightedRoot> roots);
    Missing hold(WorkerProxy& proxy, TreeId tree, std::span<const RootIndex> roots);
    /// Its blocks of these are there. Of a tree that is not here, or roots out of range: nothing.
    void arrived(const WorkerProxy& proxy, TreeId tree, std::span<const RootIndex> roots);
    void arrived(const WorkerProxy& proxy, TreeId tree, std::span<const WeightedRoot> roots);
    /// It holds these no longer. The same.
    void release(WorkerProxy& proxy, TreeId tree, std::span<const RootIndex> roots);

    /// No two proxies share a slot; slots without one hold nothing; what is coming is held; counts
    /// are what they count.
    void check() const;

  private:
    [[nodiscard]] std::uint32_t free_slot();
    static void hold_root(WorkerProxy& proxy, PooledTree& tree, RootIndex root, Missing& missing);
    void check_tree(const PooledTree& tree) const;

    std::map<WorkerId, WorkerProxy> proxies_;
    std::vector<WorkerProxy*> in_order_;
    std::map<TreeId, PooledTree> trees_;
    std::vector<bool> slot_taken_;
};

} // namespace cd
