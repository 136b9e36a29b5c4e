// All workers known to the master (the paper's "client manager", section 6.4.1).
#pragma once

#include "master/dispatch/workers/worker_proxy.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace cd {

/// The workers' proxies in ascending order of id. Gives each worker a slot.
class WorkerPool {
  public:
    /// Adds a worker, whose id must be new.
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

    /// Time between two messages of a worker that bounds how many all workers send per second, s.
    [[nodiscard]] double message_seconds() const;

    /// For each slot so far, whether a worker has it.
    [[nodiscard]] const std::vector<bool>& slots_taken() const { return slot_taken_; }

    /// Aborts unless each worker has a slot of its own, and the order is right.
    void check() const;

  private:
    /// Lowest free slot; adds one if all are taken.
    [[nodiscard]] std::uint32_t free_slot();

    std::map<WorkerId, WorkerProxy> proxies_;
    std::vector<WorkerProxy*> in_order_;
    std::vector<bool> slot_taken_;
};

} // namespace cd
