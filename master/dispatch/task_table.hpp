// The tasks in flight: sends them, ends them, and tracks their copies and recalls.
#pragma once

#include "master/dispatch/dispatch_actions.hpp"
#include "master/dispatch/work_queue.hpp"
#include "master/dispatch/workers/cluster_pace.hpp"
#include "master/dispatch/workers/worker_pool.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace cd {

/// An unanswered recall.
struct PendingRecall {
    TaskId task;
    std::uint64_t asked = 0; ///< Number of recalled scenarios or positions.
    WorkerId helper;         ///< Worker that is to get the returned work.
    double since = 0;        ///< Time of the recall, s.
};

/// Numbers the tasks, and keeps each in its worker's `WorkerTasks`. Scenarios that leave a task
/// unanswered return to the queue.
class TaskTable {
  public:
    TaskTable(WorkerPool& pool, WorkQueue& queue, const ClusterPace& pace)
        : pool_(pool), queue_(queue), pace_(pace) {}

    // ---- Sending ------------------------------------------------------------------------------
    /// Sends scenarios from the queue or from the worker's buffer, which are in no task. `claims`:
    /// the worker gets nothing else until the task ends.
    void send(WorkerProxy& proxy,
              DispatchJob& job,
              std::vector<std::uint64_t> scenarios,
              bool claims,
              Actions& actions);
    /// Sends positions that are in no task. `each_ns`: predicted time of one position.
    void send_places(WorkerProxy& proxy,
                     DispatchJob& job,
                     const PlaceRange& places,
                     std::uint64_t each_ns,
                     Actions& actions);
    /// Sends a speculative copy of a sent scenario. `fetches`: the helper lacks blocks of it.
    void send_copy(
        WorkerProxy& helper, DispatchJob& job, std::uint64_t index, bool fetches, Actions& actions);
    /// Sends a speculative copy of `count` positions of a range: the last ones without a copy.
    void copy_places(
        WorkerProxy& from, TaskId task, WorkerProxy& helper, std::uint64_t count, Actions& actions);

    // ---- Answers and ends ---------------------------------------------------------------------
    /// Removes the answered scenario from queue, buffer or task, but not from the job. If it had a
    /// copy, cancels it at the worker that did not answer. `by`: the worker that answered.
    void withdraw(DispatchJob& job,
                  std::uint64_t index,
                  DispatchScenario& scenario,
                  WorkerId by,
                  Actions& actions);
    /// Ends a task of the worker. The unanswered rest is queued again; lost scenarios may become
    /// suspects or be given up. Returns the task.
    TaskInFlight end(WorkerProxy& proxy, TaskId task, LostWith lost_with, Actions& actions);
    /// Ends all tasks of a lost worker, and forgets its recall.
    void lose_all(WorkerProxy& proxy, Actions& actions);
    /// Scenarios of the task that must be answered before it ends; 0 if the worker drains or does
    /// not exist.
    [[nodiscard]] std::uint64_t owed(WorkerId worker, TaskId task) const;

    // ---- Recalls ------------------------------------------------------------------------------
    /// Recalls `count` scenarios or positions for the helper. The worker must have no open recall.
    void ask_back(AskBack ask, std::uint64_t count, WorkerId helper, Actions& actions);
    /// The unanswered recalls, at most one per worker.
    [[nodiscard]] const std::map<WorkerId, PendingRecall>& recalls() const { return recalls_; }
    /// Ignored if the worker has no open recall.
    void forget_recall(WorkerId worker) { recalls_.erase(worker); }
    /// Takes back the part that the worker has returned of one of its tasks.
    void take_recalled(WorkerProxy& proxy, const Recalled& recalled, Actions& actions);

    /// Highest id of any task so far; 0 before the first.
    [[nodiscard]] TaskId last() const { return TaskId{last_}; }

  private:
    /// Queues the scenarios of an ended batch again, or gives up those lost too often.
    void take_back(TaskId task, const TaskInFlight& ended, LostWith lost_with, Actions& actions);
    /// Returns the number of scenarios that were in the task.
    std::uint64_t
    take_recalled_scenarios(WorkerProxy& proxy, DispatchJob& job, const Recalled& recalled);
    void answer_sent(DispatchJob& job,
                     std::uint64_t index,
                     const DispatchScenario& scenario,
                     WorkerId by,
                     Actions& actions);

    WorkerPool& pool_;
    WorkQueue& queue_;
    const ClusterPace& pace_;
    std::map<WorkerId, PendingRecall> recalls_;
    std::uint64_t last_ = 0;
};

} // namespace cd
