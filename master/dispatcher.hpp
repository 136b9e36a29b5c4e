// Decides which worker gets which scenario and when: a state machine without sockets, clocks or
// threads. Events go in, actions come out.
#pragma once

#include "common/core/id.hpp"
#include "master/matchmaker.hpp"
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

/// What the dispatcher knows of a job's tree.
struct DispatchTree {
    TreeId tree;
    std::vector<std::uint32_t> root_triangles; ///< Of each distribution root.
};

/// A scenario that needs a worker: it has at least one pair of colliding roots.
struct AnalysedScenario {
    std::uint64_t index = 0;
    std::vector<RootIndex> roots_a; ///< Ascending.
    std::vector<RootIndex> roots_b;
    std::uint64_t bytes = 0; ///< What it adds to a batch on the wire.
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

    /// Scenarios that wait or are buffered, not yet sent: what limits the submitter.
    [[nodiscard]] std::uint64_t unsent() const;
    /// The parts of a WorkerStatus that the dispatcher knows (claimed, draining, buffered, working,
    /// tasks, scenarios).
    [[nodiscard]] WorkerStatus worker_status(WorkerId worker) const;
    [[nodiscard]] std::vector<WorkerId> workers() const;

    /// Aborts when an invariant is broken; for tests, after each event.
    void check_invariants() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace cd
