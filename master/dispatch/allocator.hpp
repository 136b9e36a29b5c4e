// Moves scenarios from the queue into the workers' buffers.
#pragma once

#include "master/dispatch/blocks/block_needs.hpp"
#include "master/dispatch/order/worker_filler.hpp"
#include "master/dispatch/policy/matching_policy.hpp"
#include "master/dispatch/task_table.hpp"

namespace cd {

/// Serves the jobs in their order. Each job's policy chooses the workers.
class Allocator {
  public:
    Allocator(const MatchingContext& context,
              WorkQueue& queue,
              TaskTable& tasks,
              BlockNeeds& blocks,
              WorkerFiller& filler)
        : context_(context), queue_(queue), tasks_(tasks), blocks_(blocks), filler_(filler) {}

    /// Assigns waiting scenarios while workers can take them, and sends ripe buffers.
    void settle(Actions& actions);
    /// Assigns a newly queued scenario if possible. `resumes`: the input was paused until now.
    void take_up(DispatchJob& job, bool is_suspect, bool resumes, Actions& actions);
    /// Sends the ripe buffers of all workers.
    void flush_all(Actions& actions);
    /// Returns the worker's buffered scenarios to the heads of their jobs' queues.
    void take_back_buffers(WorkerProxy& proxy);

  private:
    /// Sends each suspect, alone in a task, to an idle worker.
    void give_suspects(Actions& actions);
    /// Buffers one waiting scenario at a worker, or lets one worker pull a task. False if no worker
    /// can take work of the job.
    bool allocate_one(DispatchJob& job, Actions& actions);
    /// Sets each worker's batch size for matching by time.
    void set_batches();

    MatchingContext context_;
    WorkQueue& queue_;
    TaskTable& tasks_;
    BlockNeeds& blocks_;
    WorkerFiller& filler_;
};

} // namespace cd
