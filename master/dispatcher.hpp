// Decides which worker gets which scenario and when: a state machine without sockets, clocks or
// threads. Events go in, actions come out.
#pragma once

#include "common/core/id.hpp"
#include "master/dispatch_tree.hpp"
#include "master/finish_estimate.hpp"
#include "master/worker_proxy.hpp"
#include "proto/message.hpp"

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

    friend bool operator==(const SendBatch&, const SendBatch&) = default;
};

/// This scenario has been lost with `limits::scenario_losses_max` workers; it fails.
struct GiveUp {
    JobId job;
    std::uint64_t scenario = 0;

    friend bool operator==(const GiveUp&, const GiveUp&) = default;
};

using Action = std::variant<SendBatch, GiveUp>;
using Actions = std::vector<Action>;

/// A scenario that needs a worker: it has at least one pair of colliding roots.
struct AnalysedScenario {
    std::uint64_t index = 0;
    std::vector<RootIndex> roots_a; ///< Ascending.
    std::vector<RootIndex> roots_b;
    std::uint64_t bytes = 0; ///< What it adds to a batch on the wire.
    /// Predicted, of one thread; only how scenarios compare matters. 0: not known.
    std::uint64_t predicted_ns = 0;
};

/// What a worker's threads did for scenarios of a task that it has answered.
struct MeasuredWork {
    TaskId task;
    std::uint64_t predicted_ns = 0; ///< The sum of their predictions,
    double seconds = 0;             ///< and what they took, summed over the threads.
};

/// Every scenario that came in is, at any time, in exactly one place: waiting, in one worker's
/// buffer, in one task at one worker, or answered. Each event returns what has to be done now.
class Dispatcher {
  public:
    Dispatcher();
    ~Dispatcher();
    Dispatcher(const Dispatcher&) = delete;
    Dispatcher& operator=(const Dispatcher&) = delete;

    Actions worker_joined(WorkerId worker, const WorkerFacts& facts);
    /// Its buffer and its tasks go back to the waiting scenarios, first in line.
    Actions worker_lost(WorkerId worker);
    /// It gets nothing more; what it has, it finishes.
    Actions worker_draining(WorkerId worker);

    Actions job_opened(JobId job, const ClusterOptions& options, DispatchTree a, DispatchTree b);
    Actions scenario_analysed(JobId job, AnalysedScenario scenario);
    /// Nothing more comes at once: workers that would run dry get what is in their buffers.
    Actions input_paused();
    /// Forgets the job's scenarios, wherever they are. Late results of it are ignored.
    Actions job_closed(JobId job);

    /// The scenario is answered, by whichever worker. Of a scenario already answered: nothing.
    Actions scenario_answered(WorkerId worker, JobId job, std::uint64_t scenario);
    /// The worker has sent all results of the task. Scenarios of it that are not answered go back:
    /// those of a draining worker are handed back, those of another one count as lost with it.
    Actions task_ended(WorkerId worker, TaskId task);
    Actions roots_evicted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots);

    // ---- What matching by time learns from. Without these events it goes by what it assumes ----
    /// The time is `seconds` from now on, from whatever beginning; never less than before.
    void time_is(double seconds);
    void work_measured(WorkerId worker, const MeasuredWork& work);
    /// So many bytes of blocks reached the worker in that time.
    void transfer_measured(WorkerId worker, std::uint64_t bytes, double seconds);
    /// The worker has these blocks.
    void roots_arrived(WorkerId worker, TreeId tree, std::span<const RootIndex> roots);

    /// Scenarios that wait or are buffered, not yet sent: what limits the submitter.
    [[nodiscard]] std::uint64_t unsent() const;
    /// How many unsent scenarios are enough to choose from; more only take memory.
    [[nodiscard]] std::uint64_t unsent_enough() const;
    /// The parts of a WorkerStatus that the dispatcher knows (claimed, draining, buffered, working,
    /// tasks, scenarios).
    [[nodiscard]] WorkerStatus worker_status(WorkerId worker) const;
    [[nodiscard]] std::vector<WorkerId> workers() const;
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
