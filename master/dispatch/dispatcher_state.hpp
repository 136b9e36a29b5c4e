// Internal state of the dispatcher, shared by its source files.
#pragma once

#include "master/dispatch/dispatcher.hpp"
#include "master/dispatch/policy/matchmaker.hpp"
#include "master/dispatch/worker_pool.hpp"

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace cd {

/// State of an unanswered scenario.
enum class Whereabouts : std::uint8_t {
    Waiting,  ///< In its job's queue.
    Suspect,  ///< In the queue for one last, separate attempt.
    Buffered, ///< In a worker's buffer.
    Sent,     ///< In a task at a worker.
};

struct Assignment {
    WorkerId worker;
    TaskId task;
};

struct DispatchScenario {
    ScenarioRoots roots;
    ScenarioWeight weight;
    bool fetches = false; ///< The worker lacked some blocks.
    Losses losses;        ///< Tasks that ended without its answer.
    Whereabouts where = Whereabouts::Waiting;
    WorkerId worker;                ///< Set if Buffered or Sent.
    TaskId task;                    ///< Set if Sent.
    std::optional<Assignment> copy; ///< Speculative copy; only if Sent.
    bool was_copied = false;
    std::uint32_t recalls = 0; ///< Number of times it was returned after a recall.

    /// A scenario that was lost may kill its worker, so it is not copied.
    [[nodiscard]] bool may_be_copied() const { return !was_copied && losses.none(); }
    [[nodiscard]] bool is_in(TaskId one) const {
        return where == Whereabouts::Sent && (task == one || (copy && copy->task == one));
    }
};

/// How fast all workers process ranges of a job, and how much is left.
struct PlaceTotals {
    double rate = 0;         ///< Scenarios/s of all workers that take work.
    double unclaimed = 0;    ///< Scenarios/s of unclaimed workers.
    double quickest = 0;     ///< Best rate per thread, unclaimed workers.
    double quickest_but = 0; ///< Second-best worker's rate per thread.
    WorkerId quickest_worker;
    std::uint64_t left = 0; ///< Unanswered: unsent, or at an unclaimed worker.
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

    [[nodiscard]] bool is_by_time() const { return options.strategy == Strategy::EarliestFinish; }
    [[nodiscard]] bool is_pulled() const { return options.strategy == Strategy::BestMatchPull; }
    /// The paper's strategies announce nothing before they send a task.
    [[nodiscard]] bool hints() const { return is_by_time() && options.hints; }
    /// The scenario must be unanswered, as all scenarios in buffers, tasks and queues are.
    [[nodiscard]] DispatchScenario& at(std::uint64_t index);
    [[nodiscard]] const DispatchScenario& at(std::uint64_t index) const;

    JobId id;
    ClusterOptions options;
    DispatchTree a;
    DispatchTree b;
    Matchmaker matchmaker;
    std::unordered_map<std::uint64_t, DispatchScenario> scenarios; ///< All unanswered scenarios.
    std::deque<std::uint64_t> waiting;

    std::deque<PlaceRange> places;                   ///< Ranges given but not sent.
    std::uint64_t places_unsent = 0;                 ///< Number of positions in `places`.
    std::uint64_t places_after = 0;                  ///< Scenarios of the job that follow `places`.
    LearnedRate place_rate;                          ///< Range scenarios per second and thread.
    std::map<WorkerId, LearnedRate> place_rates;     ///< Rate of each worker.
    mutable std::optional<PlaceTotals> place_totals; ///< Computed once per event.

    LearnedRate missing_matched;      ///< Seconds to fetch missing blocks, per matched scenario.
    LearnedRate missing_any;          ///< Seconds per scenario on any worker.
    std::uint64_t scenarios_held = 0; ///< Scenarios whose blocks were assigned to a worker.
    double missing_seconds = 0;       ///< Fetch time of the matched scenarios not yet averaged.
    double missing_in_ranges = 0;     ///< Fetch time of ranges since the last answers.

    std::uint64_t work_ns = 0;   ///< Predicted time of all work received or sent.
    std::uint64_t copied_ns = 0; ///< Predicted time of all work ever copied.
};

[[nodiscard]] DispatchScenario make_dispatch_scenario(const DispatchJob& job,
                                                      const AnalysedScenario& analysed);

struct Suspect {
    JobId job;
    std::uint64_t scenario = 0;
};

/// Missing blocks of both trees of a job.
struct MissingOfJob {
    WorkerPool::Missing a;
    WorkerPool::Missing b;

    [[nodiscard]] bool is_nothing() const { return a.roots.empty() && b.roots.empty(); }
};

/// An unanswered recall.
struct PendingRecall {
    TaskId task;
    std::uint64_t asked = 0; ///< Scenarios or positions.
    WorkerId helper;         ///< The worker that will take them.
    double since = 0;
};

/// A worker with buffered work, and the estimated time until it finishes everything.
struct Backlog {
    double seconds = 0;
    WorkerProxy* worker = nullptr;

    /// Ties are ordered by id, the smallest last.
    friend bool operator<(const Backlog& one, const Backlog& other) {
        return std::pair(one.seconds, other.worker->id()) <
               std::pair(other.seconds, one.worker->id());
    }
};

struct Dispatcher::State {
    WorkerPool pool;
    std::map<JobId, DispatchJob> jobs;
    /// Scenarios whose next loss is the last. Each travels alone, to an idle worker, so that one
    /// deadly scenario does not take others with it.
    std::deque<Suspect> suspects;
    std::map<WorkerId, PendingRecall> recalls; ///< At most one per worker.
    /// The job that was served last; the next in order is served next.
    JobId served_last;
    DispatcherOptions options;
    double settled = -1; ///< Time of the last check of all workers.
    double helped = -1;  ///< Time of the last check for stragglers.
    bool input_is_paused = true;
    std::uint64_t unsent = 0;
    std::uint64_t task_last = 0;
    double now = 0;
    WorkerPace general;       ///< Average of all workers; used for unmeasured ones.
    LearnedRate mean_cost_ns; ///< Predicted nanoseconds per scenario, recent ones.
    // Scratch buffers.
    std::vector<WorkerCandidate> candidates;
    std::vector<std::uint32_t> slots;          ///< Slots of `candidates`.
    std::vector<std::uint64_t> held_triangles; ///< Indexed by slot.

    [[nodiscard]] DispatchJob* find_job(JobId job);

    // ---- Handing out (dispatcher_flow.cpp) ----------------------------------------------------
    /// Assigns waiting scenarios as far as workers can take them, and flushes ripe buffers.
    void settle(Actions& actions);
    /// True if enough time has passed since `last` to check all workers again.
    [[nodiscard]] bool is_due(double last) const;
    /// True if some scenario is in no buffer and no task.
    [[nodiscard]] bool something_waits() const;
    /// Buffers one waiting scenario of the next job in round robin. False if none can be placed.
    bool allocate_next(Actions& actions);
    bool allocate_one(DispatchJob& job, Actions& actions);
    [[nodiscard]] WorkerProxy* choose(DispatchJob& job, const DispatchScenario& scenario);
    /// Collects the workers that may get a scenario of the job now.
    void gather_candidates(const DispatchJob& job);
    void score_candidates(const DispatchJob& job, const DispatchScenario& scenario);
    /// Returns the missing blocks.
    MissingOfJob hold_roots(DispatchJob& job, DispatchScenario& scenario, WorkerProxy& proxy);
    /// Marks the roots as held; the missing blocks are under way. Returns the missing blocks.
    MissingOfJob hold_all(const DispatchJob& job, const ScenarioRoots& roots, WorkerProxy& proxy);
    /// Announces missing blocks for a scenario that stays in the buffer for now.
    static void
    hint(const WorkerProxy& proxy, const DispatchJob& job, MissingOfJob missing, Actions& actions);
    void give_suspects(Actions& actions);
    /// The worker being emptied for suspect scenarios; null if there are none.
    [[nodiscard]] const WorkerProxy* reserved() const;

    /// Flushes the worker's buffers that are full or needed now into its free task slots.
    void flush_ripe(WorkerProxy& proxy, Actions& actions);
    [[nodiscard]] DispatchJob* next_ripe(const WorkerProxy& proxy);
    [[nodiscard]] bool is_ripe(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] bool is_full(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] bool has_room_for_task(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] bool would_run_dry(const WorkerProxy& proxy, const DispatchJob& job) const;
    void flush(WorkerProxy& proxy, DispatchJob& job, Actions& actions);
    /// Call if the worker has less work than before and nothing else has changed.
    void refill(WorkerProxy& proxy, Actions& actions);
    void send(WorkerProxy& proxy,
              DispatchJob& job,
              std::vector<std::uint64_t> scenarios,
              bool claims,
              Actions& actions);

    // ---- Ranges (dispatcher_ranges.cpp) ---------------------------------------------------------
    /// Totals of this event. Work sent meanwhile does not change them.
    [[nodiscard]] const PlaceTotals& place_totals(const DispatchJob& job) const;
    /// Call at the start of an event, or after any other change.
    void forget_place_totals() const;
    /// Sends ranges to workers that would run dry.
    void give_places(Actions& actions);
    void give_places_to(WorkerProxy& proxy, Actions& actions);
    [[nodiscard]] DispatchJob* next_with_places(const WorkerProxy& proxy);
    [[nodiscard]] bool takes_places(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// True if one scenario would finish there long after the others have done all that is left.
    [[nodiscard]] bool would_be_late(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// Range scenarios of the job that the worker's threads finish per second.
    [[nodiscard]] double places_per_second(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] std::uint64_t places_at_once(const WorkerProxy& proxy,
                                               const DispatchJob& job) const;
    void send_places(WorkerProxy& proxy, DispatchJob& job, Actions& actions);
    /// Fraction of both trees' roots that the worker does not hold.
    [[nodiscard]] double missing_share(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] double missing_with_any(const DispatchJob& job, const DispatchScenario& scenario);
    /// Samples the missing blocks. Call before a worker holds the scenario.
    void measure_missing(DispatchJob& job, const DispatchScenario& scenario);
    /// Estimated seconds until the blocks arrive.
    [[nodiscard]] double seconds_of(const WorkerPool::Missing& missing,
                                    const WorkerProxy& proxy) const;

    // ---- Pull: a free worker takes the most similar scenarios (dispatcher_pull.cpp) -------------
    /// Lets one worker pull a task's worth. False if none can.
    bool pull_one(DispatchJob& job, Actions& actions);
    [[nodiscard]] bool can_pull(const WorkerProxy& proxy, const DispatchJob& job) const;
    void pull(WorkerProxy& proxy, DispatchJob& job, Actions& actions);

    // ---- Matching by time (dispatcher_by_time.cpp) ----------------------------------------------
    [[nodiscard]] double speed_of(const WorkerProxy& proxy) const;
    [[nodiscard]] double link_of(const WorkerProxy& proxy) const;
    [[nodiscard]] WorkerPowers powers_of(const WorkerProxy& proxy) const;
    /// Predicted seconds of work that all its threads do per second.
    [[nodiscard]] double power_of(const WorkerProxy& proxy) const;
    [[nodiscard]] bool takes_by_time(const WorkerProxy& proxy) const;
    /// The worker with the earliest finish for the scenario. Null if no worker takes any.
    [[nodiscard]] WorkerProxy* earliest(const DispatchJob& job, const DispatchScenario& scenario);
    [[nodiscard]] FinishTerms finish_on(const WorkerProxy& proxy,
                                        const DispatchJob& job,
                                        const DispatchScenario& scenario) const;
    /// Sets each worker's batch size.
    void set_batches();
    [[nodiscard]] bool has_room_by_time(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] bool runs_dry_by_time(const WorkerProxy& proxy) const;
    /// True if its scenarios are so long that each is a batch, and no more will arrive.
    [[nodiscard]] bool ends_with_long_ones(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// Number of unsent scenarios that fills the batches of all workers.
    [[nodiscard]] std::uint64_t enough_by_time() const;
    /// Takes the head of a buffer, up to the batch size.
    [[nodiscard]] std::vector<std::uint64_t> take_batch(WorkerProxy& proxy, const DispatchJob& job);
    [[nodiscard]] ScenarioWeight sum_of_weights(const DispatchJob& job,
                                                std::span<const std::uint64_t> scenarios) const;
    /// Moves buffered scenarios to workers that run dry and would finish them earlier.
    void rebalance(Actions& actions);
    void add_backlog(std::vector<Backlog>& full, WorkerProxy& proxy) const;
    /// Moves scenarios that `to` would finish earlier, until it has enough.
    void move(WorkerProxy& from, WorkerProxy& to);
    [[nodiscard]] bool move_one(WorkerProxy& from, WorkerProxy& to, DispatchJob& job);
    [[nodiscard]] bool
    move_if_earlier(WorkerProxy& from, WorkerProxy& to, DispatchJob& job, std::uint64_t index);

    // ---- The end of a job (dispatcher_end.cpp) --------------------------------------------------
    [[nodiscard]] bool nothing_waits() const;
    /// Gives idle workers the work that others would finish later.
    void help_at_end(Actions& actions);
    /// Fastest first.
    [[nodiscard]] std::vector<WorkerProxy*> helpers() const;
    [[nodiscard]] bool can_help(const WorkerProxy& proxy) const;
    /// Seconds until the worker finishes all tasks sent to it.
    [[nodiscard]] double ends_in(const WorkerProxy& proxy) const;
    /// Stragglers that others may help, latest finish first. If there are many, those unchecked for
    /// longest.
    [[nodiscard]] std::vector<WorkerProxy*> late_workers();
    /// True if a recall is pending and may still be answered.
    [[nodiscard]] bool may_answer_recall(const WorkerProxy& proxy) const;
    /// True if it has work that can be recalled or copied.
    [[nodiscard]] bool may_be_helped(const WorkerProxy& from) const;
    [[nodiscard]] bool can_be_copied(const ProxyTask& task) const;
    /// False if nothing would finish earlier that way.
    [[nodiscard]] bool helps(WorkerProxy& from, WorkerProxy& helper, Actions& actions);
    [[nodiscard]] bool ask_back(WorkerProxy& from, const WorkerProxy& helper, Actions& actions);
    [[nodiscard]] AskBack
    batch_to_ask(const WorkerProxy& from, TaskId task, const WorkerProxy& helper) const;
    [[nodiscard]] AskBack
    range_to_ask(const WorkerProxy& from, TaskId task, const WorkerProxy& helper) const;
    /// Number of positions to move so that both finish together; 0 if that gains less than the
    /// factor `gain`.
    [[nodiscard]] std::uint64_t places_to_move(const WorkerProxy& from,
                                               const DispatchJob& job,
                                               const WorkerProxy& helper,
                                               double seconds_here,
                                               double gain) const;
    void take_recalled(WorkerProxy& proxy, const Recalled& recalled, Actions& actions);
    /// Returns how many were taken.
    std::uint64_t
    take_recalled_scenarios(WorkerProxy& proxy, DispatchJob& job, const Recalled& recalled);
    /// Removes the scenario, unanswered, from the task. True: its copy remains in another task.
    static bool leave_task(DispatchScenario& scenario, TaskId task);
    [[nodiscard]] bool copy(WorkerProxy& from, WorkerProxy& helper, Actions& actions);
    [[nodiscard]] bool
    copy_scenario(WorkerProxy& from, TaskId task, WorkerProxy& helper, Actions& actions);
    [[nodiscard]] bool
    copy_places(WorkerProxy& from, TaskId task, WorkerProxy& helper, Actions& actions);
    /// Predicted time of the work that may still be copied.
    [[nodiscard]] static std::uint64_t copies_left_ns(const DispatchJob& job);

    // ---- Explaining (dispatcher_explain.cpp) ----------------------------------------------------
    [[nodiscard]] std::string whereabouts(const DispatchJob& job, std::uint64_t index) const;
    [[nodiscard]] WorkerScore score_of(const WorkerProxy& proxy,
                                       const DispatchJob& job,
                                       const DispatchScenario& scenario) const;
    [[nodiscard]] bool may_take(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// Chooses among the workers that may take it. No worker's id if none may, or if workers pull.
    [[nodiscard]] WorkerId would_choose(DispatchJob& job, const DispatchScenario& scenario);

    // ---- Taking back ----------------------------------------------------------------------------
    /// Returns buffered scenarios to the head of the queue.
    void take_back_buffers(WorkerProxy& proxy);
    /// True if the scenario was lost too often and must be given up. No worker has it.
    [[nodiscard]] static bool is_lost_for_good(const DispatchScenario& scenario);
    /// Queues the scenario as a suspect if its next loss would be the last.
    bool suspect(JobId job, std::uint64_t index, DispatchScenario& scenario);
    /// Requeues the unanswered scenarios of an ended task; lost ones may become suspects or be
    /// given up.
    void take_back(TaskId task, const ProxyTask& ended, LostWith lost_with, Actions& actions);
    /// Returns the unanswered rest of an ended task to the queue.
    void end_task(TaskId task, const ProxyTask& ended, LostWith lost_with, Actions& actions);
    /// Removes the scenario from its buffer or task, but keeps its entry. Cancels a copy at another
    /// worker.
    void withdraw(DispatchJob& job,
                  std::uint64_t index,
                  DispatchScenario& scenario,
                  WorkerId by,
                  Actions& actions);
    void wait_first(DispatchJob& job, std::span<const std::uint64_t> scenarios);
    [[nodiscard]] bool is_tree_used(TreeId tree) const;

    // ---- Invariants (dispatcher_invariants.cpp) -------------------------------------------------
    void check_counts() const;
    void check_job(const DispatchJob& job) const;
    void
    check_copy(const DispatchJob& job, std::uint64_t index, const DispatchScenario& scenario) const;
    void check_recalls() const;
    void check_worker(const WorkerProxy& proxy) const;
    void check_flight(const WorkerProxy& proxy) const;
    void check_progress() const;
};

} // namespace cd
