// Moves buffered scenarios to workers that run dry, for strategies that move work.
#pragma once

#include "master/dispatch/order/worker_filler.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace cd {

/// A worker that runs dry takes over scenarios from the worker with the latest estimated finish, as
/// far as it would finish them earlier, transfers included.
class Rebalancer {
  public:
    Rebalancer(const MatchingContext& context,
               WorkQueue& queue,
               BlockNeeds& blocks,
               WorkerFiller& filler)
        : context_(context), queue_(queue), blocks_(blocks), filler_(filler) {}

    void rebalance(Actions& actions);

  private:
    /// A worker with buffered work, and the estimated time until it finishes everything.
    struct Backlog {
        double seconds = 0;
        WorkerProxy* worker = nullptr;

        /// Of two backlogs with equal times, the one with the smaller worker id is the greater.
        friend bool operator<(const Backlog& one, const Backlog& other) {
            return std::pair(one.seconds, other.worker->id()) <
                   std::pair(other.seconds, one.worker->id());
        }
    };

    void add_backlog(std::vector<Backlog>& full, WorkerProxy& proxy) const;
    /// Moves scenarios that `to` would finish earlier, until `to` has work for two batches.
    void move(WorkerProxy& from, WorkerProxy& to);
    [[nodiscard]] bool move_one(WorkerProxy& from, WorkerProxy& to, DispatchJob& job);
    [[nodiscard]] bool
    move_if_earlier(WorkerProxy& from, WorkerProxy& to, DispatchJob& job, std::uint64_t position);

    MatchingContext context_;
    WorkQueue& queue_;
    BlockNeeds& blocks_;
    WorkerFiller& filler_;
};

} // namespace cd
