// Fills workers up with tasks: of the jobs that have work for a worker, the first in the order of
// jobs sends the next task to it.
#pragma once

#include "master/dispatch/blocks/block_needs.hpp"
#include "master/dispatch/policy/matching_policy.hpp"
#include "master/dispatch/range_sender.hpp"
#include "master/dispatch/task_table.hpp"

namespace cd {

/// A job alone in the cluster keeps as many tasks at a worker as its policy allows. With several
/// jobs, the first job in the order that has work for the worker sends the next task, once the
/// worker would run dry, and no other job sends any before. So a job that comes first begins soon,
/// even if the worker is full of another's work.
class WorkerFiller {
  public:
    WorkerFiller(const MatchingContext& context,
                 WorkQueue& queue,
                 TaskTable& tasks,
                 BlockNeeds& blocks,
                 RangeSender& ranges)
        : context_(context), queue_(queue), tasks_(tasks), blocks_(blocks), ranges_(ranges) {}

    /// Sends the worker all that it may have now: ripe buffers, scenarios that it pulls, ranges.
    void fill(WorkerProxy& proxy, Actions& actions);
    /// Fills all workers, if any job has positions that go out without analysis.
    void give_ranges(Actions& actions);
    /// Sends the worker's ripe buffers. If there are several jobs, fills the worker.
    void flush_ripe(WorkerProxy& proxy, Actions& actions);
    /// Sends the job's buffer at the worker while it is full and has room there. If there are
    /// several jobs, fills the worker instead.
    void flush_full(WorkerProxy& proxy, DispatchJob& job, Actions& actions);
    /// Lets the first worker that may pull a task of the job now pull it. False if no worker may.
    bool pull_one(DispatchJob& job, Actions& actions);

    /// True if the worker's buffer of the job must be sent at the job's turn: the worker has room
    /// for a task, and the buffer is full, or gets no more for now while the worker runs dry.
    [[nodiscard]] bool is_ripe(const WorkerProxy& proxy, const DispatchJob& job) const;

  private:
    // ---- With several jobs ----
    /// True if the job has a buffer for the worker that is full or gets no more for now.
    [[nodiscard]] bool has_buffer_for(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// True if the job has such a buffer and the worker may get one more task of the job.
    [[nodiscard]] bool wants_to_flush(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// True if the worker may pull a task of the job, or the few scenarios that are left of it.
    [[nodiscard]] bool wants_to_pull(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// True if the worker would run dry, or has tasks of this job alone and may have one more.
    [[nodiscard]] bool may_send(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// The first job in the order that has work for the worker. Null if there is none, or if its
    /// work must wait: then work of a later job goes out only if the worker would run dry.
    [[nodiscard]] DispatchJob* next(const WorkerProxy& proxy) const;
    void fill_in_turn(WorkerProxy& proxy, Actions& actions);

    [[nodiscard]] bool has_several_jobs() const { return queue_.jobs().size() > 1; }
    void flush(WorkerProxy& proxy, DispatchJob& job, Actions& actions);
    void pull(WorkerProxy& proxy, DispatchJob& job, Actions& actions);

    MatchingContext context_;
    WorkQueue& queue_;
    TaskTable& tasks_;
    BlockNeeds& blocks_;
    RangeSender& ranges_;
};

} // namespace cd
