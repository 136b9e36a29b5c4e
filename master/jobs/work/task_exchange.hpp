// Sends tasks to the workers, and takes their ends and returns.
#pragma once

#include "master/dispatch/dispatch_driver.hpp"
#include "master/geometry/tree_registry.hpp"
#include "master/jobs/job_table.hpp"
#include "master/jobs/work/lease_book.hpp"
#include "master/workers/worker_directory.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// Sends jobs and trees ahead of the tasks that need them. Owns the book of tasks.
class TaskExchange {
  public:
    /// All references outlive the exchange.
    TaskExchange(JobTable& jobs,
                 WorkerDirectory& workers,
                 const TreeRegistry& trees,
                 DispatchDriver& dispatch)
        : jobs_(jobs), workers_(workers), trees_(trees), dispatch_(dispatch) {}

    [[nodiscard]] LeaseBook& book() { return book_; }
    [[nodiscard]] const LeaseBook& book() const { return book_; }

    // ---- Actions of the dispatcher ------------------------------------------------------------
    void send(const SendBatch& batch);
    void send(const SendRange& range);
    void send(const SendHint& hint);
    void send(const AskBack& ask);
    void send(const CallOff& loser);

    // ---- From a worker ------------------------------------------------------------------------
    /// The worker has sent all results of the task.
    void ended(WorkerId worker, TaskId task);
    /// The worker returns part of the task, or says what it has of it. Ignores unknown tasks.
    void recalled(WorkerId worker, const Recalled& recalled);
    /// A message of results of the task has been merged, or dropped. Ignores unknown tasks.
    void checked(TaskId task);
    /// Compares the tasks with the worker's inventory, after messages may have been lost.
    void compare(WorkerId worker, std::span<const Recalled> present);
    /// Returns the unanswered work of the worker's tasks to the queue, not counted as lost, and
    /// gives the worker no more work.
    void take_all_back(WorkerId worker);

    // ---- Scenarios that are not to be run -----------------------------------------------------
    /// Cancels speculative copies of `scenario` on all workers except `worker`.
    void call_off_copies(JobId job, WorkerId worker, std::uint64_t scenario);
    /// Stops the scenario on all workers.
    void drop(JobId job, std::uint64_t scenario);
    /// Tells a worker that knows the job which of its scenarios are cancelled.
    static void drop_cancelled(const Worker& worker, const MasterJob& job);

    /// Measures whether the worker has work from now on.
    void note_work(WorkerId worker);

  private:
    void add_job_to(Worker& worker, const MasterJob& job);
    void end_if_complete(TaskId id, Lease& task);

    JobTable& jobs_;
    WorkerDirectory& workers_;
    const TreeRegistry& trees_;
    DispatchDriver& dispatch_;
    LeaseBook book_;
};

} // namespace cd
