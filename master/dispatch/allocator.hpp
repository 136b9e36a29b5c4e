// Moves scenarios from the queue through the workers' buffers into tasks.
#pragma once

#include "master/dispatch/block_needs.hpp"
#include "master/dispatch/policy/matching_policy.hpp"
#include "master/dispatch/task_table.hpp"

namespace cd {

/// Serves the jobs in turn, each by its policy.
class Allocator {
  public:
    Allocator(const MatchingContext& context,
              WorkQueue& queue,
              TaskTable& tasks,
              BlockNeeds& blocks)
        : context_(context), queue_(queue), tasks_(tasks), blocks_(blocks) {}

    /// Assigns waiting scenarios as far as workers can take them, and flushes ripe buffers.
    void settle(Actions& actions);
    /// A scenario was added to the job's queue, the first after a pause if the input resumes.
    void take_up(DispatchJob& job, bool is_suspect, bool resumes, Actions& actions);
    /// Flushes the worker's buffers that are full or needed now into its free task slots.
    void flush_ripe(WorkerProxy& proxy, Actions& actions);
    /// Call if the worker has less work than before and nothing else has changed.
    void refill(WorkerProxy& proxy, Actions& actions);
    /// Returns buffered scenarios to the head of the queue.
    void take_back_buffers(WorkerProxy& proxy);
    /// The worker's buffer must be sent now.
    [[nodiscard]] bool is_ripe(const WorkerProxy& proxy, const DispatchJob& job) const;

  private:
    /// Sends suspects to idle workers.
    void give_suspects(Actions& actions);
    /// Assigns one waiting scenario, or lets one worker pull a task's worth. False if none can be
    /// placed.
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
