// Decides when which worker gets which scenarios. A state machine without sockets, clocks or
// threads: each event returns the actions that follow from it.
#pragma once

#include "common/core/id.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "master/base/position_set.hpp"
#include "master/dispatch/dispatch_actions.hpp"
#include "master/dispatch/dispatch_inputs.hpp"
#include "master/dispatch/dispatch_tree.hpp"
#include "master/dispatch/order/job_order.hpp"
#include "master/dispatch/view/dispatch_view.hpp"
#include "master/dispatch/workers/worker_proxy.hpp"
#include "proto/messages/cluster_options.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// A scenario is named by its position in the job's hand-out order. It comes analysed, to be
/// matched with a worker, or in a range without analysis, for the first worker that runs dry.
///
/// Each unanswered position is in exactly one state: waiting, in one worker's buffer, or in one
/// task. Two exceptions exist. At the end of a job a position in a task may have one speculative
/// copy in a task of another worker. A recalled part stays in its task until the worker confirms
/// its return.
///
/// Each event returns the actions to perform now.
class Dispatcher : public DispatchView {
  public:
    explicit Dispatcher(const DispatcherOptions& options = {});
    Dispatcher(const Dispatcher&) = delete;
    Dispatcher& operator=(const Dispatcher&) = delete;

    Actions worker_joined(WorkerId worker, const WorkerFacts& facts);
    /// Queues the lost worker's analysed scenarios again, and drops its ranges (PositionsLost).
    Actions worker_lost(WorkerId worker);
    /// Gives the worker no more work; the worker finishes the tasks sent to it.
    Actions worker_draining(WorkerId worker);
    /// The worker may be lost: its buffer returns to the queue. Until `worker_heard`, the worker
    /// gets no new work, but keeps the work sent to it.
    Actions worker_silent(WorkerId worker);
    Actions worker_heard(WorkerId worker);

    Actions
    job_opened(JobId job, const ClusterOptions& options, DispatchTrees trees, JobRank rank = {});
    /// Gives an open job another priority. Work that was sent stays where it is.
    Actions job_ranked(JobId job, std::int32_t priority);
    /// The master's pool has analysed so many positions of the job in `seconds` of a thread; 0 if
    /// that was not measured.
    void analysis_took(JobId job, std::uint64_t positions, double seconds);
    Actions scenario_analysed(JobId job, AnalysedScenario scenario);
    /// No more scenarios arrive for now: workers about to run dry get the scenarios in their
    /// buffers.
    Actions input_paused();
    /// Like `input_paused`, for one job that is open.
    Actions job_input_paused(JobId job);
    /// The given positions may go out without analysis, to the first workers that run dry. `after`:
    /// number of the job's scenarios that follow the given ones.
    Actions positions_given(JobId job, GivenRange given, std::uint64_t after);
    /// Removes and returns the positions that came with `positions_given` and are in no task.
    [[nodiscard]] std::vector<PositionRange> take_positions(JobId job);
    /// Forgets the job and all its positions. Later answers for the job are ignored.
    Actions job_closed(JobId job);

    /// Records answers. Ignores positions that were answered before.
    Actions answered(const Answers& answers);
    /// The worker has sent all results of the task. Unanswered positions return to the queue, and
    /// do not count as lost.
    Actions task_ended(WorkerId worker, TaskId task);
    /// The task was lost on its way to the worker, which is alive. Unanswered positions return to
    /// the queue, and do not count as lost.
    Actions task_unbegun(WorkerId worker, TaskId task);
    /// The worker has returned these positions of the task, in answer to AskBack or in its
    /// inventory (Inventory). The positions wait again, and do not count as lost. Ignores positions
    /// that the task lacks.
    Actions task_recalled(WorkerId worker, TaskId task, const PositionSet& returned);
    /// The worker requests these blocks and counts as holding them from now on.
    void roots_wanted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots);
    Actions roots_evicted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots);

    // ---- Measurements for matching by time, which uses defaults until they arrive ----
    /// Sets the time, in seconds since any fixed point; it never decreases.
    void time_is(double seconds);
    /// Records that `bytes` of blocks reached the worker in `seconds`.
    void transfer_measured(WorkerId worker, std::uint64_t bytes, double seconds);
    /// Records that the worker holds these blocks: they have reached it, or it has kept them.
    void roots_arrived(WorkerId worker, TreeId tree, std::span<const RootIndex> roots);

  private:
    /// Appends the actions that have become possible, after checking all workers and jobs.
    Actions settled(Actions actions);
    /// Appends the actions that give the worker more work. Suffices instead of `settled` if only
    /// this worker's load has decreased.
    Actions refilled(WorkerProxy& proxy, Actions actions);
    /// `settled` if a check of all workers is due or scenarios wait for any worker; else
    /// `refilled`.
    Actions settled_or_refilled(WorkerProxy& proxy, Actions actions);
    /// Null if the worker does not exist, or has no such task.
    [[nodiscard]] WorkerProxy* worker_with(WorkerId worker, TaskId task);
    /// Tells the order of jobs how many threads there are.
    void count_threads();
    /// True if enough time has passed to check all workers again.
    [[nodiscard]] bool is_due() const;

    DispatcherOptions options_;
    double settled_ = -1; ///< Time of the last check of all workers, s.
};

} // namespace cd
