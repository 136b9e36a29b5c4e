// All workers that the master knows (the paper's "client manager", section 6.4.1).
#pragma once

#include "common/tree/root_holders.hpp"
#include "master/worker_proxy.hpp"

#include <map>
#include <span>
#include <vector>

namespace cd {

/// Proxies in ascending order of id, and what they hold, or were allocated, of each tree (paper,
/// 5.1 and 6.4.5).
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

    // ---- What they hold. A worker is its proxy's slot
    // --------------------------------------------
    void add_tree(TreeId tree, std::uint32_t root_count);
    void remove_tree(TreeId tree) { holders_.erase(tree); }
    /// The tree has been added.
    [[nodiscard]] const RootHolders& holders(TreeId tree) const;
    void hold(const WorkerProxy& proxy, TreeId tree, std::span<const WeightedRoot> roots);
    /// Of a tree that is not here, or roots out of range: nothing.
    void release(const WorkerProxy& proxy, TreeId tree, std::span<const RootIndex> roots);
    /// No two proxies share a slot, and slots without one hold nothing.
    void check_slots() const;

  private:
    [[nodiscard]] std::uint32_t free_slot();

    std::map<WorkerId, WorkerProxy> proxies_;
    std::vector<WorkerProxy*> in_order_;
    std::map<TreeId, RootHolders> holders_;
    std::vector<bool> slot_taken_;
};

} // namespace cd
