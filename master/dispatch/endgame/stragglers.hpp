// Finds workers that are late at a job's end, and idle workers that can help.
#pragma once

#include "master/dispatch/policy/matching_policy.hpp"
#include "master/dispatch/task_table.hpp"

#include <vector>

namespace cd {

/// The finish estimate follows from a worker's measured speed and its time without answers (LATE:
/// Zaharia et al., Improving MapReduce Performance in Heterogeneous Environments, 2008).
class Stragglers {
  public:
    Stragglers(const MatchingContext& context, const TaskTable& tasks)
        : context_(context), tasks_(tasks) {}

    /// The worker has fewer scenarios than threads, and no recalled work is on its way to it.
    [[nodiscard]] bool can_help(const WorkerProxy& proxy) const;
    /// Workers that can help, the fastest first.
    [[nodiscard]] std::vector<WorkerProxy*> helpers() const;
    /// Seconds until the worker finishes all tasks sent to it.
    [[nodiscard]] double ends_in(const WorkerProxy& proxy) const;
    /// Stragglers that others may help, latest finish first. If there are many, those unchecked for
    /// longest.
    [[nodiscard]] std::vector<WorkerProxy*> late() const;
    /// The worker may be asked to return work.
    [[nodiscard]] bool may_be_asked(const WorkerProxy& from) const;
    /// True if a recall is pending and may still be answered.
    [[nodiscard]] bool may_answer_recall(const WorkerProxy& from) const;

  private:
    [[nodiscard]] bool is_pending(const PendingRecall& recall) const;
    /// True if it has work that can be recalled or copied.
    [[nodiscard]] bool may_be_helped(const WorkerProxy& from) const;
    [[nodiscard]] bool can_be_copied(const TaskInFlight& task) const;

    MatchingContext context_;
    const TaskTable& tasks_;
};

} // namespace cd
