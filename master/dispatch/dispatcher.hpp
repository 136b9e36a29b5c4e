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

/// Send these scenarios to this worker as one task.
struct SendBatch {
    WorkerId worker;
    TaskId task;
    JobId job;
    std::vector<std::uint64_t> scenarios;
    bool is_copy = false; ///< They are at another worker, too.

    friend bool operator==(const SendBatch&, const SendBatch&) = default;
};

/// Send these places of the job's order to this worker as one task; it finds the colliding roots
/// itself.
struct SendRange {
    WorkerId worker;
    TaskId task;
    JobId job;
    PlaceRange places;
    TaskId copy_of = {}; ///< Another worker's task, which has these places, too.

    friend bool operator==(const SendRange&, const SendRange&) = default;
};

/// Ask the worker for what it has not begun of the task: of a batch these scenarios, of a range all
/// places but the first so many.
struct AskBack {
    WorkerId worker;
    TaskId task;
    std::vector<std::uint64_t> scenarios; ///< Ascending.
    std::uint64_t places = 0;

    friend bool operator==(const AskBack&, const AskBack&) = default;
};

/// A worker has given back part of a task. Unanswered places are to be queued again.
struct GivenBack {
    TaskId task;
    JobId job;
    std::uint64_t scenarios = 0; ///< For batches.
    PlaceRange places;           ///< For ranges.

    friend bool operator==(const GivenBack&, const GivenBack&) = default;
};

/// Another worker has answered the scenario: this one need not.
struct CallOff {
    WorkerId worker;
    TaskId task;
    JobId job;
    std::uint64_t scenario = 0;

    friend bool operator==(const CallOff&, const CallOff&) = default;
};

/// The process with which a task was lost; empty if its unanswered rest was handed back.
using LostWith = std::optional<WorkerProcess>;

/// The task of a range has ended. Its unanswered places are to be done again, and analysed first if
/// they were lost.
struct RangeEnded {
    TaskId task;
    JobId job;
    PlaceRange places;
    LostWith lost_with;

    friend bool operator==(const RangeEnded&, const RangeEnded&) = default;
};

/// The worker will need these blocks for scenarios that wait in its buffer.
struct SendHint {
    WorkerId worker;
    JobId job;
    TreeId tree;
    std::vector<RootIndex> roots; ///< Ascending.

    friend bool operator==(const SendHint&, const SendHint&) = default;
};

/// Scenarios of a batch that were lost with a worker and go to another one. Comes before any of
/// them is sent again.
struct ScenariosLost {
    JobId job;
    std::vector<std::uint64_t> scenarios;
    WorkerProcess process = 0;

    friend bool operator==(const ScenariosLost&, const ScenariosLost&) = default;
};

/// This scenario has been lost with `limits::scenario_losses_max` workers' processes; it fails.
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
    std::uint64_t bytes = 0; ///< Added to a batch on the wire.
    /// Predicted time on one thread; only ratios between scenarios matter. 0 if not known.
    std::uint64_t predicted_ns = 0;
    /// Earlier losses: with ranges, or before the master was restarted.
    Losses losses = {};
};

/// The work of a worker's threads on answered scenarios of a task.
struct MeasuredWork {
    TaskId task;
    std::uint64_t predicted_ns = 0; ///< Sum of the scenarios' predictions.
    double seconds = 0;             ///< Measured, summed over the threads.
};

struct DispatcherOptions {
    bool helps_at_end = true; ///< False: nothing is recalled or copied.
    /// With more workers than `workers_few`, the others are re-examined after a change only every
    /// `look_seconds_each` seconds for each worker beyond them.
    std::size_t workers_few = limits::workers_few;
    double look_seconds_each = limits::look_seconds_each;
};

/// Every scenario that came in is, at any time, in exactly one place: waiting, in one worker's
/// buffer, in one task at one worker, or answered. Places that came in wait, are in one task, or
/// have ended with it. But at the end of a job a scenario, or places, in a task may have one copy,
/// in a task of its own at another worker; and what is recalled stays in its task until the worker
/// says that it has given it back. Each event returns what has to be done now.
class Dispatcher {
  public:
    explicit Dispatcher(const DispatcherOptions& options = {});
    ~Dispatcher();
    Dispatcher(const Dispatcher&) = delete;
    Dispatcher& operator=(const Dispatcher&) = delete;

    Actions worker_joined(WorkerId worker, const WorkerFacts& facts);
    /// Its buffer and its tasks go back to the waiting scenarios, first in line.
    Actions worker_lost(WorkerId worker);
    /// The worker gets nothing more and finishes what it has.
    Actions worker_draining(WorkerId worker);
    /// The worker may be lost: its buffer is returned, and it gets nothing until it is heard again.
    /// Sent work stays with it.
    Actions worker_silent(WorkerId worker);
    Actions worker_heard(WorkerId worker);

    Actions job_opened(JobId job, const ClusterOptions& options, DispatchTree a, DispatchTree b);
    Actions scenario_analysed(JobId job, AnalysedScenario scenario);
    /// No more scenarios come for now: workers that would run dry get the scenarios in their
    /// buffers.
    Actions input_paused();
    /// These places of the job may go out without an analysis, to whoever runs dry first; after
    /// them come `after` more scenarios of the job.
    Actions places_given(JobId job, const PlaceRange& places, std::uint64_t after);
    /// Returns the places that were given and not sent.
    [[nodiscard]] std::vector<PlaceRange> take_places(JobId job);
    /// Forgets the job's scenarios, wherever they are. Late results of it are ignored.
    Actions job_closed(JobId job);

    /// The scenario is answered, by whichever worker. Of a scenario already answered: nothing.
    Actions scenario_answered(WorkerId worker, JobId job, std::uint64_t scenario);
    /// So many scenarios of a range are answered; they took its threads that long. Of a task that
    /// is not here: nothing.
    Actions places_answered(WorkerId worker, TaskId task, std::uint64_t count, double busy_seconds);
    /// The worker has sent all results of the task. Scenarios of it that are not answered go back,
    /// and do not count as lost.
    Actions task_ended(WorkerId worker, TaskId task);
    /// The task got lost on its way to the worker, which is well: what of it is not answered goes
    /// back, and does not count as lost.
    Actions task_unbegun(WorkerId worker, TaskId task);
    /// This was given back of the task, in answer to AskBack or as the worker stands: it waits
    /// again, and is not lost. What was given back before, or is not in the task: nothing.
    Actions task_recalled(WorkerId worker, const Recalled& recalled);
    /// The worker asks for these blocks; from now on it counts as holding them.
    void roots_wanted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots);
    Actions roots_evicted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots);

    // ---- Measurements for matching by time, which else uses its defaults ----
    /// Sets the time, in seconds since any fixed point; it never decreases.
    void time_is(double seconds);
    void work_measured(WorkerId worker, const MeasuredWork& work);
    /// `bytes` of blocks reached the worker in `seconds`.
    void transfer_measured(WorkerId worker, std::uint64_t bytes, double seconds);
    /// The worker has these blocks.
    void roots_arrived(WorkerId worker, TreeId tree, std::span<const RootIndex> roots);

    /// Scenarios that wait or are buffered, not yet sent: what limits the submitter.
    [[nodiscard]] std::uint64_t unsent() const;
    /// Nothing waits, and some workers have nothing to do while others work: from time to time
    /// `input_paused` finds out who is late.
    [[nodiscard]] bool is_at_end() const;
    /// How many unsent scenarios are enough to choose from; more only take memory.
    [[nodiscard]] std::uint64_t unsent_enough() const;
    /// Places given and not sent, and how many are enough for all workers. The job is open.
    [[nodiscard]] std::uint64_t places_unsent(JobId job) const;
    [[nodiscard]] std::uint64_t places_enough(JobId job) const;
    /// What analysed scenarios of the job lack where they are sent, and what would be lacking with
    /// any worker, in seconds each; and what it takes until all hold all. The job is open.
    [[nodiscard]] MissingCosts missing_costs(JobId job) const;
    /// The parts of a WorkerStatus that the dispatcher knows (claimed, draining, buffered, working,
    /// tasks, scenarios).
    [[nodiscard]] WorkerStatus worker_status(WorkerId worker) const;
    [[nodiscard]] std::vector<WorkerId> workers() const;
    /// The tasks at the worker, which is here.
    [[nodiscard]] std::vector<TaskId> tasks_of(WorkerId worker) const;
    /// Scenarios of the task that would have to be answered before it ends: 0 of a worker that
    /// drains, or is not here.
    [[nodiscard]] std::uint64_t owed(WorkerId worker, TaskId task) const;
    /// Scenarios that were analysed and are not answered: 0 of a job that is not open. The places
    /// that were given and not sent; the job is open.
    [[nodiscard]] std::uint64_t unanswered(JobId job) const;
    [[nodiscard]] std::vector<PlaceRange> places_of(JobId job) const;
    /// How each worker scores for the scenario as things stand, and which would be chosen. Changes
    /// nothing. The job is open.
    [[nodiscard]] Explained explain(JobId job, const AnalysedScenario& scenario) const;

    /// Aborts when an invariant is broken; for tests, after each event.
    void check_invariants() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace cd
