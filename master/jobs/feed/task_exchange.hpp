// Sends tasks to the workers, and handles the messages that end or return tasks.
#pragma once

#include "master/dispatch/dispatch_driver.hpp"
#include "master/geometry/tree_registry.hpp"
#include "master/jobs/feed/lease_book.hpp"
#include "master/jobs/job_table.hpp"
#include "master/workers/worker_directory.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// Owns the book of leases. Sends a worker the job and its trees before the job's first task.
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
    void send(const SendUnit& unit);
    void send(const SendHint& hint);
    void send(const AskBack& ask);
    void send(const UnitsReturned& returned);
    void send(const CallOff& loser);

    // ---- From a worker ------------------------------------------------------------------------
    /// The worker has sent all results of the task.
    void ended(WorkerId worker, TaskId task);
    /// The worker returns part of the task, or lists in its inventory the part that it has. Ignores
    /// unknown tasks.
    void recalled(WorkerId worker, const Recalled& recalled);
    /// A result message of the task has been checked, and merged or dropped. Ignores unknown tasks.
    void checked(WorkerId worker, TaskId task);
    /// Resynchronises the worker's tasks with its inventory `present`, after a reconnection.
    void compare(WorkerId worker, std::span<const Recalled> present);
    /// Returns the unanswered work of the worker's tasks to the queue, without counting it as lost,
    /// and gives the worker no more work.
    void take_all_back(WorkerId worker);

    // ---- Cancelled scenarios ------------------------------------------------------------------
    /// Cancels the scenario on all workers that know the job.
    void drop(JobId job, std::uint64_t scenario);
    /// Tells a worker that knows the job which of its scenarios are cancelled.
    static void drop_cancelled(const Worker& worker, const MasterJob& job);

    /// Updates the worker's busy time. Call when the worker may have become busy or idle.
    void note_work(WorkerId worker);

  private:
    [[nodiscard]] static TaskContent content_of(const MasterJob& job, const SendUnit& unit);
    /// Sends the job and its trees, unless the worker has them.
    void add_job_to(Worker& worker, const MasterJob& job);
    /// Ends the task once the worker has sent all results and these are checked. Cuts off a worker
    /// that has left out answers.
    void end_if_complete(WorkerId worker, TaskId task, const Lease& lease);

    JobTable& jobs_;
    WorkerDirectory& workers_;
    const TreeRegistry& trees_;
    DispatchDriver& dispatch_;
    LeaseBook book_;
};

} // namespace cd
