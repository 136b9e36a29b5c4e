// Questions that the dispatcher answers between two events.
#pragma once

#include "common/core/id.hpp"
#include "master/base/position_set.hpp"
#include "master/dispatch/dispatch_inputs.hpp"
#include "master/dispatch/range_choice.hpp"
#include "master/dispatch/view/growth.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace cd {

struct DispatchParts;

/// Owns the dispatcher's parts. Only the events of `Dispatcher` change them.
class DispatchView {
  public:
    /// Analysed scenarios that wait or are buffered; this number throttles the analyser. Positions
    /// that go out without analysis are counted by `positions_unsent`.
    [[nodiscard]] std::uint64_t unsent() const;
    /// The job's analysed scenarios that wait or are buffered. The job must be open.
    [[nodiscard]] std::uint64_t unsent_of(JobId job) const;
    /// True if `one` is to be analysed before `other`. Both jobs must be open.
    [[nodiscard]] bool is_analysed_before(JobId one, JobId other) const;
    /// The job's part of the thread time of the last seconds (`JobOrder::share`).
    [[nodiscard]] double share(JobId job) const;
    /// True if nothing waits and some workers are idle while others work. Call `input_paused` from
    /// time to time then, to find stragglers.
    [[nodiscard]] bool is_at_end() const;
    /// Number of unsent scenarios that gives workers enough choice; more would only take memory.
    [[nodiscard]] std::uint64_t unsent_enough() const;
    /// Number of positions that came with `positions_given` and are in no task. The job must be
    /// open.
    [[nodiscard]] std::uint64_t positions_unsent(JobId job) const;
    /// Number of unsent positions that suffices for all workers. The job must be open.
    [[nodiscard]] std::uint64_t positions_enough(JobId job) const;
    /// Cost of the blocks that analysed scenarios lack at their chosen worker and at an average
    /// one, in seconds per scenario, and of filling every cache. The job must be open.
    [[nodiscard]] MissingCosts missing_costs(JobId job) const;
    /// True if the job's analysed work moves to workers that would finish it earlier. The job must
    /// be open.
    [[nodiscard]] bool moves_work(JobId job) const;
    /// The present workers, for an estimate of how much more would help.
    [[nodiscard]] WorkersNow workers_now() const;
    /// The parts of a WorkerStatus that the dispatcher knows: claimed, draining, buffered, working,
    /// tasks, scenarios.
    [[nodiscard]] WorkerStatus worker_status(WorkerId worker) const;
    [[nodiscard]] std::vector<WorkerId> workers() const;
    /// Tasks at the worker, which must exist.
    [[nodiscard]] std::vector<TaskId> tasks_of(WorkerId worker) const;
    /// Positions of the task that must be answered before it ends; 0 if the worker drains or does
    /// not exist.
    [[nodiscard]] std::uint64_t owed(WorkerId worker, TaskId task) const;
    /// True if the task exists and is a speculative copy.
    [[nodiscard]] bool is_copy(WorkerId worker, TaskId task) const;
    /// Scenarios analysed but not answered; 0 if the job is not open.
    [[nodiscard]] std::uint64_t unanswered(JobId job) const;
    /// The unanswered positions that came with `positions_given`, in tasks or not. The job must be
    /// open.
    [[nodiscard]] PositionSet unanalysed(JobId job) const;
    /// Scores every worker for the scenario in the present state, and names the worker that would
    /// be chosen. Changes nothing. The job must be open.
    [[nodiscard]] Explained explain(JobId job, const AnalysedScenario& scenario) const;

    /// Aborts if an invariant is broken. For tests; call it after each event.
    void check_invariants() const;

  protected:
    DispatchView();
    ~DispatchView();
    [[nodiscard]] DispatchParts& parts() const { return *parts_; }

  private:
    std::unique_ptr<DispatchParts> parts_;
};

} // namespace cd
