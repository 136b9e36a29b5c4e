// Makes ranges: consecutive positions of a job, without analysis or matching. At the worker's
// measured rate, a range lasts as long as a batch. Towards the end of a job, ranges get shorter,
// down to the time of a round trip to the worker.
#pragma once

#include "master/dispatch/policy/matching_policy.hpp"
#include "master/dispatch/task_table.hpp"

#include <cstdint>

namespace cd {

class RangeSender {
  public:
    RangeSender(const MatchingContext& context, WorkQueue& queue, TaskTable& tasks)
        : context_(context), queue_(queue), tasks_(tasks) {}

    /// Sends the worker, which would take it, its next range of the job.
    void send(WorkerProxy& proxy, DispatchJob& job, Actions& actions);
    /// Number of unsent positions of the job that suffices for all workers.
    [[nodiscard]] std::uint64_t enough(const DispatchJob& job) const;
    /// True if the worker would get a range of the job at the job's turn: it would run dry.
    [[nodiscard]] bool would_take(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// True if the job has a range for the worker, which may have too many tasks to get it now.
    [[nodiscard]] bool has_range_for(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// True if the worker could get a range of the job, however much it has to do.
    [[nodiscard]] bool may_take(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// Drops the cached totals of all jobs. Call after a change of the workers, and where an event
    /// looks at all workers anyway.
    void forget_totals() const;
    /// Call at the start of an event that relieves single workers. Drops the cached totals that
    /// have served as many events as one count of them may cost.
    void age_totals() const;

  private:
    /// The job's totals, counted anew if they were dropped. Work sent and answered since the count
    /// does not change them.
    [[nodiscard]] const RangeTotals& totals(const DispatchJob& job) const;
    /// True if the worker would finish one scenario long after the others have finished the rest.
    [[nodiscard]] bool would_be_late(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// Time that a range should take the worker while much work is left, s.
    [[nodiscard]] double range_seconds(const WorkerProxy& proxy) const;
    /// Number of positions in the worker's next range of the job.
    [[nodiscard]] std::uint64_t positions_at_once(const WorkerProxy& proxy,
                                                  const DispatchJob& job) const;

    MatchingContext context_;
    WorkQueue& queue_;
    TaskTable& tasks_;
};

} // namespace cd
