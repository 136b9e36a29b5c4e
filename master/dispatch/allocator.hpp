// Moves scenarios from the queue through the workers' buffers into tasks.
#pragma once

#include "master/dispatch/blocks/block_needs.hpp"
#include "master/dispatch/policy/matching_policy.hpp"
#include "master/dispatch/task_table.hpp"

namespace cd {

/// Serves the jobs round robin. Each job's policy chooses the workers and forms the tasks.
class Allocator {
  public:
    Allocator(const MatchingContext& context,
              WorkQueue& queue,
              TaskTable& tasks,
              BlockNeeds& blocks)
        : context_(context), queue_(queue), tasks_(tasks), blocks_(blocks) {}

    /// Assigns waiting scenarios while workers can take them, and sends ripe buffers (`is_ripe`).
    void settle(Actions& actions);
    /// Assigns a newly queued scenario if possible. `resumes`: the input was paused until now.
    void take_up(DispatchJob& job, bool is_suspect, bool resumes, Actions& actions);
    /// Sends the worker's ripe buffers as tasks, while the worker has room for tasks.
    void flush_ripe(WorkerProxy& proxy, Actions& actions);
    /// Gives the worker more work: its ripe buffers, and scenarios that it pulls. Suffices instead
    /// of `settle` if only this worker's load has decreased.
    void refill(WorkerProxy& proxy, Actions& actions);
    /// Returns the worker's buffered scenarios to the heads of their jobs' queues.
    void take_back_buffers(WorkerProxy& proxy);
    /// True if the worker's buffer of the job must be sent now: the worker has room for a task, and
    /// the buffer is full, or gets no more for now while the worker runs dry.
    [[nodiscard]] bool is_ripe(const WorkerProxy& proxy, const DispatchJob& job) const;

  private:
    /// Sends each suspect, alone in a task, to an idle worker.
    void give_suspects(Actions& actions);
    /// Buffers one waiting scenario at a worker, or lets one worker pull a task. False if no worker
    /// can take work of the job.
    bool allocate_one(DispatchJob& job, Actions& actions);
    /// Sets each worker's batch size for matching by time.
    void set_batches();
    void flush(WorkerProxy& proxy, DispatchJob& job, Actions& actions);
    bool pull_one(DispatchJob& job, Actions& actions);
    void pull(WorkerProxy& proxy, DispatchJob& job, Actions& actions);

    MatchingContext context_;
    WorkQueue& queue_;
    TaskTable& tasks_;
    BlockNeeds& blocks_;
};

} // namespace cd
