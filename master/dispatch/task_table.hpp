// The tasks in flight: sends them, ends them, and tracks their copies and recalls.
#pragma once

#include "master/dispatch/blocks/block_plan.hpp"
#include "master/dispatch/dispatch_actions.hpp"
#include "master/dispatch/endgame/open_recalls.hpp"
#include "master/dispatch/work_queue.hpp"
#include "master/dispatch/workers/cluster_pace.hpp"
#include "master/dispatch/workers/worker_pool.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace cd {

/// Numbers the tasks, and keeps each in its worker's `WorkerTasks`. Positions that leave all their
/// tasks unanswered return to the queue.
class TaskTable {
  public:
    TaskTable(WorkerPool& pool, BlockPlan& plan, WorkQueue& queue, ClusterPace& pace)
        : pool_(pool), plan_(plan), queue_(queue), pace_(pace) {}

    // ---- Sending ------------------------------------------------------------------------------
    /// Sends scenarios from the queue or from the worker's buffer, which are in no task. `claims`:
    /// the worker gets nothing else until the task ends.
    void send(WorkerProxy& proxy,
              DispatchJob& job,
              std::vector<std::uint64_t> positions,
              bool claims,
              Actions& actions);
    /// Sends positions without analysis, which are in no task. `each_ns`: predicted time of one.
    void send_range(WorkerProxy& proxy,
                    DispatchJob& job,
                    const GivenRange& range,
                    std::uint64_t each_ns,
                    Actions& actions);
    /// Sends the helper a speculative copy of unanswered positions of the task `original`.
    /// `fetches`: the helper lacks blocks for the copy.
    void send_copy(const Assignment& original,
                   WorkerProxy& helper,
                   const PositionSet& positions,
                   bool fetches,
                   Actions& actions);

    // ---- Answers and ends ---------------------------------------------------------------------
    /// Workers whose load has decreased.
    struct Relieved {
        std::set<WorkerId> workers;
        bool any_unsent = false; ///< Some positions were unsent, so any worker may take more.
    };
    /// Removes the answered positions wherever they are, cancels their speculative copies, and
    /// learns the worker's speed. Ignores positions that were answered before.
    Relieved answer(DispatchJob& job, const Answers& answers, Actions& actions);
    /// Ends a task of the worker. The unanswered rest is queued again; lost scenarios may become
    /// suspects or be given up. Returns the task.
    TaskInFlight end(WorkerProxy& proxy, TaskId task, LostWith lost_with, Actions& actions);
    /// Ends all tasks of a lost worker, and forgets its recall.
    void lose_all(WorkerProxy& proxy, Actions& actions);
    /// Null if there is no such task.
    [[nodiscard]] const TaskInFlight* find(const Assignment& task) const;
    /// Positions of the task that must be answered before it ends; 0 if the worker drains or does
    /// not exist.
    [[nodiscard]] std::uint64_t owed(const Assignment& task) const;

    // ---- Recalls ------------------------------------------------------------------------------
    /// Recalls positions from a straggler for the helper. The straggler must have no open recall.
    void ask_back(AskBack ask, WorkerId helper, Actions& actions);
    /// The unanswered recalls, at most one per worker.
    [[nodiscard]] const OpenRecalls& recalls() const { return recalls_; }
    /// Forgets the worker's open recall, if there is one.
    void forget_recall(WorkerId worker) { recalls_.remove(worker); }
    /// Queues the positions again that the worker has returned of one of its tasks.
    void
    take_recalled(WorkerProxy& proxy, TaskId task, const PositionSet& returned, Actions& actions);

    /// Highest id of any task so far; 0 before the first.
    [[nodiscard]] TaskId last() const { return TaskId{last_}; }

  private:
    /// Numbers the task, and sends it.
    void start(WorkerProxy& proxy, TaskInFlight task, Actions& actions);
    /// Removes answered positions from one task, if it exists, and returns the ones that the task
    /// had. `by`: the worker that answered.
    PositionSet answer_in(DispatchJob& job,
                          const Assignment& at,
                          WorkerId by,
                          const PositionSet& positions,
                          Relieved& relieved);
    /// Removes positions from a task that has them.
    void take_from(WorkerProxy& proxy,
                   TaskId task,
                   const DispatchJob& job,
                   const PositionSet& positions);
    /// Removes answered positions that are unsent, or in an analysed task that the worker did not
    /// name. Does not cancel them at other workers: a second answer exposes a wrong worker. Returns
    /// the positions that were not analysed.
    PositionSet answer_elsewhere(DispatchJob& job,
                                 WorkerId by,
                                 const PositionSet& positions,
                                 Relieved& relieved);
    /// Removes answered positions from the ranges of all workers. Does not cancel them there.
    void answer_in_ranges(DispatchJob& job,
                          WorkerId by,
                          const PositionSet& positions,
                          Relieved& relieved);
    /// Learns the worker's speed from answers of an existing task, predicted to take `cost_ns`.
    void learn(DispatchJob& job, const Answers& answers, std::uint64_t cost_ns);
    /// Of positions that have just left the task `left`, returns the ones that are in no task now.
    [[nodiscard]] PositionSet
    unshared(DispatchJob& job, const TaskInFlight& left, PositionSet positions);
    /// Queues positions again that are in no task any more, or gives up the ones lost too often.
    void requeue(DispatchJob& job,
                 const TaskInFlight& left,
                 const PositionSet& positions,
                 LostWith lost_with,
                 Actions& actions);
    void requeue_analysed(DispatchJob& job,
                          const PositionSet& positions,
                          LostWith lost_with,
                          Actions& actions);
    [[nodiscard]] static std::uint64_t
    cost_of(const DispatchJob& job, const TaskInFlight& task, const PositionSet& positions);

    WorkerPool& pool_;
    BlockPlan& plan_;
    WorkQueue& queue_;
    ClusterPace& pace_;
    OpenRecalls recalls_;
    std::uint64_t last_ = 0;
};

} // namespace cd
