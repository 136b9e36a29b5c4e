// The tasks in flight: what was sent to whom, what has a copy, what was asked back, and what is
// still owed.
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
    std::uint64_t asked = 0; ///< Scenarios or positions.
    WorkerId helper;         ///< The worker that will take them.
    double since = 0;        ///< s
};

/// Numbers the tasks; each stands in its worker's `WorkerTasks`. What leaves a task unanswered
/// returns to the queue.
class TaskTable {
  public:
    TaskTable(WorkerPool& pool, WorkQueue& queue, const ClusterPace& pace)
        : pool_(pool), queue_(queue), pace_(pace) {}

    // ---- Sending ------------------------------------------------------------------------------
    /// Sends scenarios that nobody has, from the queue or from the worker's buffer.
    void send(WorkerProxy& proxy,
              DispatchJob& job,
              std::vector<std::uint64_t> scenarios,
              bool claims,
              Actions& actions);
    /// Sends positions that nobody has. `each_ns`: predicted time of one.
    void send_places(WorkerProxy& proxy,
                     DispatchJob& job,
                     const PlaceRange& places,
                     std::uint64_t each_ns,
                     Actions& actions);
    /// Sends a copy of a scenario in a task to another worker, which may lack blocks of it.
    void send_copy(
        WorkerProxy& helper, DispatchJob& job, std::uint64_t index, bool fetches, Actions& actions);
    /// Sends a copy of the last positions of a range that have none to another worker.
    void copy_places(
        WorkerProxy& from, TaskId task, WorkerProxy& helper, std::uint64_t count, Actions& actions);

    // ---- Answers and ends ---------------------------------------------------------------------
    /// Removes the scenario from queue, buffer or task, but keeps its entry. Cancels a copy at
    /// another worker than the one that answered.
    void withdraw(DispatchJob& job,
                  std::uint64_t index,
                  DispatchScenario& scenario,
                  WorkerId by,
                  Actions& actions);
    /// Ends a task of the worker. The unanswered rest is queued again; lost scenarios may become
    /// suspects or be given up. Returns the task.
    TaskInFlight end(WorkerProxy& proxy, TaskId task, LostWith lost_with, Actions& actions);
    /// The worker is lost with all its tasks; nobody answers its recall.
    void lose_all(WorkerProxy& proxy, Actions& actions);
    /// Scenarios of the task that must be answered before it ends; 0 if the worker drains or does
    /// not exist.
    [[nodiscard]] std::uint64_t owed(WorkerId worker, TaskId task) const;

    // ---- Recalls ------------------------------------------------------------------------------
    /// Asks back `count` scenarios or positions, for the helper. The worker must not be asked.
    void ask_back(AskBack ask, std::uint64_t count, WorkerId helper, Actions& actions);
    /// At most one recall per worker is unanswered.
    [[nodiscard]] const std::map<WorkerId, PendingRecall>& recalls() const { return recalls_; }
    /// The worker's recall, if any, is not answered any more.
    void forget_recall(WorkerId worker) { recalls_.erase(worker); }
    /// The worker has returned part of a task that it has.
    void take_recalled(WorkerProxy& proxy, const Recalled& recalled, Actions& actions);

    [[nodiscard]] TaskId last() const { return TaskId{last_}; }

  private:
    /// The task's scenarios are queued again.
    void take_back(TaskId task, const TaskInFlight& ended, LostWith lost_with, Actions& actions);
    /// Returns how many were taken.
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
