// Ranges of order positions, without analysis or matching. The first worker to run dry gets the
// next range, sized for a batch's duration at its measured rate, and smaller towards the end of a
// job.
#pragma once

#include "master/dispatch/policy/matching_policy.hpp"
#include "master/dispatch/task_table.hpp"

#include <cstdint>

namespace cd {

/// Sends ranges to workers that would run dry.
class RangeSender {
  public:
    RangeSender(const MatchingContext& context, WorkQueue& queue, TaskTable& tasks)
        : context_(context), queue_(queue), tasks_(tasks) {}

    void give(Actions& actions);
    /// Call if the worker has less work than before and nothing else has changed.
    void give_to(WorkerProxy& proxy, Actions& actions);
    /// Positions of the job that suffice for all workers.
    [[nodiscard]] std::uint64_t enough(const DispatchJob& job) const;
    /// The worker would get a range of the job now.
    [[nodiscard]] bool would_take(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// Call at the start of an event, or after any other change but work that is sent.
    void forget_totals() const;

  private:
    /// Totals of this event. Work sent meanwhile does not change them.
    [[nodiscard]] const PlaceTotals& totals(const DispatchJob& job) const;
    void send_to(WorkerProxy& proxy, Actions& actions);
    void send(WorkerProxy& proxy, DispatchJob& job, Actions& actions);
    /// True if one scenario would finish there long after the others have done all that is left.
    [[nodiscard]] bool would_be_late(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] std::uint64_t places_at_once(const WorkerProxy& proxy,
                                               const DispatchJob& job) const;

    MatchingContext context_;
    WorkQueue& queue_;
    TaskTable& tasks_;
};

} // namespace cd
