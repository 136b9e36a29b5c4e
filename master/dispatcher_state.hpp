// The insides of the dispatcher, shared by its source files.
#pragma once

#include "master/dispatcher.hpp"
#include "master/matchmaker.hpp"
#include "master/worker_pool.hpp"

#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

namespace cd {

/// Where an unanswered scenario is.
enum class Whereabouts : std::uint8_t {
    Waiting,  ///< In its job's queue.
    Suspect,  ///< In the queue of those that get one more chance, alone.
    Buffered, ///< In a worker's buffer.
    Sent,     ///< In a task at a worker.
};

struct DispatchScenario {
    ScenarioRoots roots;
    std::uint64_t bytes = 0;
    std::uint32_t losses = 0; ///< Tasks that came to an end without its answer.
    Whereabouts where = Whereabouts::Waiting;
    WorkerId worker; ///< Of Buffered and Sent.
    TaskId task;     ///< Of Sent.
};

struct DispatchJob {
    DispatchJob(JobId job,
                const ClusterOptions& job_options,
                DispatchTree tree_a,
                DispatchTree tree_b)
        : id(job),
          options(job_options),
          a(std::move(tree_a)),
          b(std::move(tree_b)),
          matchmaker(job_options.strategy, job_options.seed) {}

    JobId id;
    ClusterOptions options;
    DispatchTree a;
    DispatchTree b;
    Matchmaker matchmaker;
    std::unordered_map<std::uint64_t, DispatchScenario> scenarios; ///< The unanswered ones.
    std::deque<std::uint64_t> waiting;
};

struct Suspect {
    JobId job;
    std::uint64_t scenario = 0;
};

struct Dispatcher::State {
    WorkerPool pool;
    std::map<JobId, DispatchJob> jobs;
    /// Lost so often that the next loss is the last. Each travels alone, to a worker without other
    /// work, so that one deadly scenario does not take its neighbours with it.
    std::deque<Suspect> suspects;
    /// Job that was served last; the next in order is served next.
    JobId served_last;
    bool input_is_paused = true;
    std::uint64_t unsent = 0;
    std::uint64_t task_last = 0;
    // Scratch.
    std::vector<WorkerCandidate> candidates;
    std::vector<std::uint32_t> slots;          ///< Of the candidates.
    std::vector<std::uint64_t> held_triangles; ///< By slot.

    [[nodiscard]] DispatchJob* find_job(JobId job);

    // ---- Handing out (dispatcher_flow.cpp) ----------------------------------------------------
    /// Gives out what waits, as far as somebody can take it, and flushes what is ripe.
    void settle(Actions& actions);
    /// One waiting scenario of the next job in turn goes to a buffer. False when none can.
    bool allocate_next(Actions& actions);
    bool allocate_one(DispatchJob& job, Actions& actions);
    /// Who may get a scenario of the job now.
    void gather_candidates(const DispatchJob& job);
    void score_candidates(const DispatchJob& job, const DispatchScenario& scenario);
    void
    hold_roots(const DispatchJob& job, const DispatchScenario& scenario, const WorkerProxy& proxy);
    void give_suspects(Actions& actions);
    /// The worker that is being emptied for suspects; null without suspects.
    [[nodiscard]] const WorkerProxy* reserved() const;

    /// Flushes the worker's buffers that are full, or that it needs now, into its free places.
    void flush_ripe(WorkerProxy& proxy, Actions& actions);
    [[nodiscard]] DispatchJob* next_ripe(const WorkerProxy& proxy);
    [[nodiscard]] bool is_ripe(const WorkerProxy& proxy, const DispatchJob& job) const;
    void flush(WorkerProxy& proxy, DispatchJob& job, Actions& actions);
    void send(WorkerProxy& proxy,
              DispatchJob& job,
              std::vector<std::uint64_t> scenarios,
              bool claims,
              Actions& actions);

    // ---- Taking back ----------------------------------------------------------------------------
    /// Buffered scenarios wait again, first in line.
    void take_back_buffers(WorkerProxy& proxy);
    /// Scenarios of an ended task without answers wait again; where they are lost, some are
    /// suspected or given up.
    void
    take_back(JobId job, std::span<const std::uint64_t> scenarios, bool are_lost, Actions& actions);
    /// Removes the scenario from where it is; its entry stays.
    void withdraw(DispatchJob& job, std::uint64_t index, DispatchScenario& scenario, WorkerId by);
    void wait_first(DispatchJob& job, std::span<const std::uint64_t> scenarios);
    [[nodiscard]] bool is_tree_used(TreeId tree) const;

    // ---- Invariants (dispatcher_invariants.cpp) -------------------------------------------------
    void check_counts() const;
    void check_job(const DispatchJob& job) const;
    void check_worker(const WorkerProxy& proxy) const;
    void check_progress() const;
};

} // namespace cd
