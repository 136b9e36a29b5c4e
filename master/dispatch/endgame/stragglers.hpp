// Finds workers that are late at a job's end, and idle workers that can help.
#pragma once

#include "master/dispatch/policy/matching_policy.hpp"
#include "master/dispatch/task_table.hpp"

#include <cstdint>
#include <vector>

namespace cd {

/// Estimates a worker's finish from its measured speed and the time since its last answer (LATE:
/// Zaharia et al., Improving MapReduce Performance in Heterogeneous Environments, 2008).
class Stragglers {
  public:
    Stragglers(const MatchingContext& context, const TaskTable& tasks)
        : context_(context), tasks_(tasks) {}

    /// True if the worker may get work, has idle threads, and awaits no recalled work.
    [[nodiscard]] bool can_help(const WorkerProxy& proxy) const;
    /// Workers that can help, the fastest first.
    [[nodiscard]] std::vector<WorkerProxy*> helpers() const;
    /// Seconds until the worker finishes all tasks sent to it.
    [[nodiscard]] double ends_in(const WorkerProxy& proxy) const;
    /// Number of positions to move so that `from` and the helper finish together. 0 unless the
    /// helper finishes one position `gain` times sooner than `from` in `seconds_here`.
    [[nodiscard]] std::uint64_t positions_to_move(const WorkerProxy& from,
                                                  const DispatchJob& job,
                                                  const WorkerProxy& helper,
                                                  double seconds_here,
                                                  double gain) const;
    /// Stragglers that others may help, latest finish first. If there are many, returns only the
    /// ones whose last check is longest ago.
    [[nodiscard]] std::vector<WorkerProxy*> late() const;
    /// True if a recall may be sent to the worker: none is open, and the worker takes work.
    [[nodiscard]] bool may_be_asked(const WorkerProxy& from) const;
    /// True if a recall of the worker is open and may still be answered.
    [[nodiscard]] bool may_answer_recall(const WorkerProxy& from) const;
    /// True if a recall may move unanswered positions of the task to another worker.
    [[nodiscard]] bool can_be_recalled(const TaskInFlight& task) const;
    /// Positions of the task that may get a speculative copy: unanswered, never copied, and never
    /// lost, because a scenario that was lost may kill a worker.
    [[nodiscard]] PositionSet copyable(const TaskInFlight& task) const;

  private:
    /// The master no longer expects answers to recalls sent at or before this time, s.
    [[nodiscard]] double recalls_expired_until() const;
    /// True if the worker has work that can be recalled or copied now.
    [[nodiscard]] bool may_be_helped(const WorkerProxy& from) const;
    /// True if the task is no copy, has work left, and is of a job whose work may move at the end.
    [[nodiscard]] bool is_movable(const TaskInFlight& task) const;

    MatchingContext context_;
    const TaskTable& tasks_;
};

} // namespace cd
