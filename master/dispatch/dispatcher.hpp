// Decides which worker gets which scenario and when: a state machine without sockets, clocks or
// threads. Events go in, actions come out.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits/master.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "master/base/worker_process.hpp"
#include "master/dispatch/dispatch_tree.hpp"
#include "master/dispatch/policy/finish_estimate.hpp"
#include "master/dispatch/range_choice.hpp"
#include "master/dispatch/worker_proxy.hpp"
#include "proto/messages/client_messages.hpp"
#include "proto/messages/cluster_options.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace cd {

/// Asks to send these scenarios to this worker as one task.
struct SendBatch {
    WorkerId worker;
    TaskId task;
    JobId job;
    std::vector<std::uint64_t> scenarios;
    bool is_copy = false; ///< Speculative copy: another worker has them too.

    friend bool operator==(const SendBatch&, const SendBatch&) = default;
};

/// Asks to send these positions of the job's order to this worker as one task. The worker finds the
/// colliding roots itself.
struct SendRange {
    WorkerId worker;
    TaskId task;
    JobId job;
    PlaceRange places;
    TaskId copy_of = {}; ///< Task of another worker with these positions; none if not a copy.

    friend bool operator==(const SendRange&, const SendRange&) = default;
};

/// Asks the worker to return what it has not begun of the task: of a batch these scenarios, of a
/// range all but its first `places` positions.
struct AskBack {
    WorkerId worker;
    TaskId task;
    std::vector<std::uint64_t> scenarios; ///< Ascending.
    std::uint64_t places = 0;

    friend bool operator==(const AskBack&, const AskBack&) = default;
};

/// A worker has returned part of a task. The unanswered positions must be queued again.
struct GivenBack {
    TaskId task;
    JobId job;
    std::uint64_t scenarios = 0; ///< Number returned of a batch.
    PlaceRange places;           ///< Positions returned of a range.

    friend bool operator==(const GivenBack&, const GivenBack&) = default;
};

/// Cancels the scenario at this worker: another one has answered it.
struct CallOff {
    WorkerId worker;
    TaskId task;
    JobId job;
    std::uint64_t scenario = 0;

    friend bool operator==(const CallOff&, const CallOff&) = default;
};

/// Process whose loss ended a task; empty if the unanswered rest was returned.
using LostWith = std::optional<WorkerProcess>;

/// The task of a range has ended. Its unanswered positions must be repeated, and are analysed first
/// if they were lost.
struct RangeEnded {
    TaskId task;
    JobId job;
    PlaceRange places;
    LostWith lost_with;

    friend bool operator==(const RangeEnded&, const RangeEnded&) = default;
};

/// Tells the worker which blocks the scenarios in its buffer will need.
struct SendHint {
    WorkerId worker;
    JobId job;
    TreeId tree;
    std::vector<RootIndex> roots; ///< Ascending.

    friend bool operator==(const SendHint&, const SendHint&) = default;
};

/// Reports scenarios of a batch that were lost with a worker. Precedes any action that resends one
/// of them.
struct ScenariosLost {
    JobId job;
    std::vector<std::uint64_t> scenarios;
    WorkerProcess process = 0;

    friend bool operator==(const ScenariosLost&, const ScenariosLost&) = default;
};

/// Fails a scenario that was lost with `limits::scenario_losses_max` worker processes.
struct GiveUp {
    JobId job;
    std::uint64_t scenario = 0;

    friend bool operator==(const GiveUp&, const GiveUp&) = default;
};

using Action = std::variant<SendBatch,
                            GiveUp,
                            SendRange,
                            RangeEnded,
                            ScenariosLost,
                            AskBack,
                            GivenBack,
                            CallOff,
                            SendHint>;
using Actions = std::vector<Action>;

/// A scenario that needs a worker: it has at least one pair of colliding roots.
struct AnalysedScenario {
    std::uint64_t index = 0;
    std::vector<RootIndex> roots_a; ///< Ascending.
    std::vector<RootIndex> roots_b;
    std::uint64_t bytes = 0; ///< Size it adds to a batch on the wire.
    /// Predicted time on one thread, 0 if unknown; only ratios between scenarios matter.
    std::uint64_t predicted_ns = 0;
    /// Losses in ranges or before a restart of the master.
    Losses losses = {};
};

/// Time that a worker's threads spent on answered scenarios of a task.
struct MeasuredWork {
    TaskId task;
    std::uint64_t predicted_ns = 0; ///< Sum of the scenarios' predictions.
    double seconds = 0;             ///< Measured, summed over the threads.
};

struct DispatcherOptions {
    bool helps_at_end = true; ///< False: never recall or copy work.
    /// With more than `workers_few` workers, a change triggers a check of all workers at most every
    /// `look_seconds_each` seconds per worker above that number.
    std::size_t workers_few = limits::workers_few;
    double look_seconds_each = limits::look_seconds_each;
};

/// Each unanswered scenario is in exactly one state: waiting, in one worker's buffer, or in one
/// task. Order positions wait, are in one task, or ended with it.
///
/// Two exceptions exist. At the end of a job a scenario or range in a task may have one speculative
/// copy in a task of another worker. A recalled part stays in its task until the worker confirms
/// its return.
///
/// Each event returns the actions to perform now.
class Dispatcher {
  public:
    explicit Dispatcher(const DispatcherOptions& options = {});
    ~Dispatcher();
    Dispatcher(const Dispatcher&) = delete;
    Dispatcher& operator=(const Dispatcher&) = delete;

    Actions worker_joined(WorkerId worker, const WorkerFacts& facts);
    /// Returns the worker's buffer and tasks to the head of the queue.
    Actions worker_lost(WorkerId worker);
    /// Gives the worker nothing more; it finishes its current work.
    Actions worker_draining(WorkerId worker);
    /// The worker may be lost: its buffer is returned, and it gets nothing until it is heard again.
    /// It keeps the work sent to it.
    Actions worker_silent(WorkerId worker);
    Actions worker_heard(WorkerId worker);

    Actions job_opened(JobId job, const ClusterOptions& options, DispatchTree a, DispatchTree b);
    Actions scenario_analysed(JobId job, AnalysedScenario scenario);
    /// No more scenarios arrive for now: workers about to run dry get the scenarios in their
    /// buffers.
    Actions input_paused();
    /// These order positions may go out without analysis, to the first workers that run dry.
    /// `after` more scenarios of the job follow them.
    Actions places_given(JobId job, const PlaceRange& places, std::uint64_t after);
    /// Takes back the positions that were given and not sent.
    [[nodiscard]] std::vector<PlaceRange> take_places(JobId job);
    /// Forgets the job and all its scenarios. Late results of it are ignored.
    Actions job_closed(JobId job);

    /// Records that some worker answered the scenario. Ignored if it was answered before.
    Actions scenario_answered(WorkerId worker, JobId job, std::uint64_t scenario);
    /// Records `count` answers of a range, which took the worker's threads `busy_seconds`. Ignored
    /// if the task does not exist.
    Actions places_answered(WorkerId worker, TaskId task, std::uint64_t count, double busy_seconds);
    /// The worker has sent all results of the task. Unanswered scenarios return to the queue, not
    /// counted as lost.
    Actions task_ended(WorkerId worker, TaskId task);
    /// The task was lost on its way to the worker, which is alive. Unanswered scenarios return to
    /// the queue, not counted as lost.
    Actions task_unbegun(WorkerId worker, TaskId task);
    /// The worker has returned this part of the task, in answer to AskBack or in its Standing. It
    /// waits again and is not counted as lost. Parts that are not in the task are ignored.
    Actions task_recalled(WorkerId worker, const Recalled& recalled);
    /// The worker requests these blocks and counts as holding them from now on.
    void roots_wanted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots);
    Actions roots_evicted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots);

    // ---- Measurements for matching by time, which has defaults without them ----
    /// Sets the time, in seconds since any fixed point; it never decreases.
    void time_is(double seconds);
    void work_measured(WorkerId worker, const MeasuredWork& work);
    /// Records that `bytes` of blocks reached the worker in `seconds`.
    void transfer_measured(WorkerId worker, std::uint64_t bytes, double seconds);
    /// Records that these blocks have reached the worker.
    void roots_arrived(WorkerId worker, TreeId tree, std::span<const RootIndex> roots);

    /// Scenarios that wait or are buffered; this number throttles the submitter.
    [[nodiscard]] std::uint64_t unsent() const;
    /// True if nothing waits and some workers are idle while others work. Call `input_paused` from
    /// time to time then, to find stragglers.
    [[nodiscard]] bool is_at_end() const;
    /// Number of unsent scenarios that gives enough choice; more only take memory.
    [[nodiscard]] std::uint64_t unsent_enough() const;
    /// Positions given and not sent, and the number that suffices for all workers. The job must be
    /// open.
    [[nodiscard]] std::uint64_t places_unsent(JobId job) const;
    [[nodiscard]] std::uint64_t places_enough(JobId job) const;
    /// Cost of the blocks that analysed scenarios lack at their chosen worker and at an average
    /// one, in seconds per scenario, and of filling every cache. The job must be open.
    [[nodiscard]] MissingCosts missing_costs(JobId job) const;
    /// The parts of a WorkerStatus that the dispatcher knows: claimed, draining, buffered, working,
    /// tasks, scenarios.
    [[nodiscard]] WorkerStatus worker_status(WorkerId worker) const;
    [[nodiscard]] std::vector<WorkerId> workers() const;
    /// Tasks at the worker, which must exist.
    [[nodiscard]] std::vector<TaskId> tasks_of(WorkerId worker) const;
    /// Scenarios of the task that must be answered before it ends; 0 if the worker drains or does
    /// not exist.
    [[nodiscard]] std::uint64_t owed(WorkerId worker, TaskId task) const;
    /// Scenarios analysed but not answered; 0 if the job is not open.
    [[nodiscard]] std::uint64_t unanswered(JobId job) const;
    [[nodiscard]] std::vector<PlaceRange> places_of(JobId job) const;
    /// Scores every worker for the scenario as of now, and tells which would be chosen. Changes
    /// nothing. The job must be open.
    [[nodiscard]] Explained explain(JobId job, const AnalysedScenario& scenario) const;

    /// Aborts if an invariant is broken. For tests; call it after each event.
    void check_invariants() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace cd
