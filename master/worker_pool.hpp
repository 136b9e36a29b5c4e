// All workers that the master knows (the paper's "client manager", section 6.4.1).
#pragma once

#include "master/worker_proxy.hpp"

#include <map>

namespace cd {

/// Proxies in ascending order of id.
class WorkerPool {
  public:
    /// The id is new.
    WorkerProxy& add(WorkerId worker, const WorkerFacts& facts);
    void remove(WorkerId worker) { proxies_.erase(worker); }

    /// Null where there is none.
    [[nodiscard]] WorkerProxy* find(WorkerId worker);
    [[nodiscard]] const WorkerProxy* find(WorkerId worker) const;
    /// The worker is here.
    [[nodiscard]] WorkerProxy& at(WorkerId worker);

    [[nodiscard]] std::map<WorkerId, WorkerProxy>& all() { return proxies_; }
    [[nodiscard]] const std::map<WorkerId, WorkerProxy>& all() const { return proxies_; }

    /// For every worker that is here now.
    void add_tree(TreeId tree, std::uint32_t root_count);
    void remove_tree(TreeId tree);

  private:
    std::map<WorkerId, WorkerProxy> proxies_;
};

} // namespace cd
