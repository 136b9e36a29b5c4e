// The insides of the dispatcher, shared by its source files.
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

/// Where an unanswered scenario is.
enum class Whereabouts : std::uint8_t {
    Waiting,  ///< In its job's queue.
    Suspect,  ///< In the queue of those that get one more chance, alone.
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
    bool fetches = false; ///< Its worker lacked blocks of it.
    Losses losses;        ///< Tasks that came to an end without its answer.
    Whereabouts where = Whereabouts::Waiting;
    WorkerId worker;                ///< Of Buffered and Sent.
    TaskId task;                    ///< Of Sent.
    std::optional<Assignment> copy; ///< Of Sent: where it is, too.
    bool was_copied = false;
    std::uint32_t recalls = 0; ///< How often it was given back when it was recalled.

    /// One that was lost may take down whoever runs it.
    [[nodiscard]] bool may_be_copied() const { return !was_copied && losses.none(); }
    [[nodiscard]] bool is_in(TaskId one) const {
        return where == Whereabouts::Sent && (task == one || (copy && copy->task == one));
    }
};

/// How quickly all workers do places of a job, and how many of them are left.
struct PlaceTotals {
    double rate = 0;         ///< Scenarios a second, of those that take work,
    double unclaimed = 0;    ///< and of those of them that are not claimed.
    double quickest = 0;     ///< Of one thread of the latter,
    double quickest_but = 0; ///< and without that worker.
    WorkerId quickest_worker;
    std::uint64_t left = 0; ///< Not answered: unsent, or at a worker that is not claimed.
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
    /// The strategies of the paper say nothing before a task is sent.
    [[nodiscard]] bool hints() const { return is_by_time() && options.hints; }
    /// The scenario is in some buffer, task or queue, and such hold none that is answered.
    [[nodiscard]] DispatchScenario& at(std::uint64_t index);
    [[nodiscard]] const DispatchScenario& at(std::uint64_t index) const;

    JobId id;
    ClusterOptions options;
    DispatchTree a;
    DispatchTree b;
    Matchmaker matchmaker;
    std::unordered_map<std::uint64_t, DispatchScenario> scenarios; ///< The unanswered ones.
    std::deque<std::uint64_t> waiting;

    std::deque<PlaceRange> places;   ///< Given, not sent.
    std::uint64_t places_unsent = 0; ///< Of these.
    std::uint64_t places_after = 0;  ///< Scenarios of the job that come after them.
    LearnedRate place_rate;          ///< Scenarios of ranges that one thread does in a second,
    std::map<WorkerId, LearnedRate> place_rates;     ///< and each worker's.
    mutable std::optional<PlaceTotals> place_totals; ///< Worked out once in an event.

    LearnedRate missing_matched;      ///< Seconds a scenario, of those that were matched,
    LearnedRate missing_any;          ///< and with any worker, or of ranges.
    std::uint64_t scenarios_held = 0; ///< By workers that were chosen for them.
    double missing_seconds = 0;       ///< Of the last of these,
    double missing_in_ranges = 0;     ///< and of ranges, since answers came.

    std::uint64_t work_ns = 0;   ///< Predicted, of all that came in or went out,
    std::uint64_t copied_ns = 0; ///< and of what is, or was, done twice.
};

[[nodiscard]] DispatchScenario make_dispatch_scenario(const DispatchJob& job,
                                                      const AnalysedScenario& analysed);

struct Suspect {
    JobId job;
    std::uint64_t scenario = 0;
};

/// Of both trees of a job.
struct MissingOfJob {
    WorkerPool::Missing a;
    WorkerPool::Missing b;

    [[nodiscard]] bool is_nothing() const { return a.roots.empty() && b.roots.empty(); }
};

/// What a worker was asked to give back, and has not answered.
struct PendingRecall {
    TaskId task;
    std::uint64_t asked = 0; ///< Scenarios or places.
    WorkerId helper;         ///< It waits for them.
    double since = 0;
};

/// A worker in whose buffer something stands, and when it would be done with all that it has.
struct Backlog {
    double seconds = 0;
    WorkerProxy* worker = nullptr;

    /// Equals in the order of their ids, the smallest last.
    friend bool operator<(const Backlog& one, const Backlog& other) {
        return std::pair(one.seconds, other.worker->id()) <
               std::pair(other.seconds, one.worker->id());
    }
};

struct Dispatcher::State {
    WorkerPool pool;
    std::map<JobId, DispatchJob> jobs;
    /// Lost so often that the next loss is the last. Each travels alone, to a worker without other
    /// work, so that one deadly scenario does not take its neighbours with it.
    std::deque<Suspect> suspects;
    std::map<WorkerId, PendingRecall> recalls; ///< One at a time of each worker.
    /// Job that was served last; the next in order is served next.
    JobId served_last;
    DispatcherOptions options;
    double settled = -1; ///< When all workers were looked at last,
    double helped = -1;  ///< and whether they need help.
    bool input_is_paused = true;
    std::uint64_t unsent = 0;
    std::uint64_t task_last = 0;
    double now = 0;
    WorkerPace general;       ///< Over all workers: stands for one that is not measured yet.
    LearnedRate mean_cost_ns; ///< Predicted nanoseconds of a scenario, of those that came last.
    // Scratch.
    std::vector<WorkerCandidate> candidates;
    std::vector<std::uint32_t> slots;          ///< Of the candidates.
    std::vector<std::uint64_t> held_triangles; ///< By slot.

    [[nodiscard]] DispatchJob* find_job(JobId job);

    // ---- Handing out (dispatcher_flow.cpp) ----------------------------------------------------
    /// Gives out what waits, as far as somebody can take it, and flushes what is ripe.
    void settle(Actions& actions);
    /// What was done then for all workers may be done again.
    [[nodiscard]] bool is_due(double last) const;
    /// A scenario that is in no buffer and no task.
    [[nodiscard]] bool something_waits() const;
    /// One waiting scenario of the next job in turn goes to a buffer. False when none can.
    bool allocate_next(Actions& actions);
    bool allocate_one(DispatchJob& job, Actions& actions);
    [[nodiscard]] WorkerProxy* choose(DispatchJob& job, const DispatchScenario& scenario);
    /// Who may get a scenario of the job now.
    void gather_candidates(const DispatchJob& job);
    void score_candidates(const DispatchJob& job, const DispatchScenario& scenario);
    /// What it lacked.
    MissingOfJob hold_roots(DispatchJob& job, DispatchScenario& scenario, WorkerProxy& proxy);
    /// The blocks that it lacked are on their way.
    MissingOfJob hold_all(const DispatchJob& job, const ScenarioRoots& roots, WorkerProxy& proxy);
    /// They are for a scenario that stays in its buffer for now.
    static void
    hint(const WorkerProxy& proxy, const DispatchJob& job, MissingOfJob missing, Actions& actions);
    void give_suspects(Actions& actions);
    /// The worker that is being emptied for suspects; null without suspects.
    [[nodiscard]] const WorkerProxy* reserved() const;

    /// Flushes the worker's buffers that are full, or that it needs now, into its free places.
    void flush_ripe(WorkerProxy& proxy, Actions& actions);
    [[nodiscard]] DispatchJob* next_ripe(const WorkerProxy& proxy);
    [[nodiscard]] bool is_ripe(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] bool is_full(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] bool has_room_for_task(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] bool would_run_dry(const WorkerProxy& proxy, const DispatchJob& job) const;
    void flush(WorkerProxy& proxy, DispatchJob& job, Actions& actions);
    /// The worker has less to do than before, and nothing else changed.
    void refill(WorkerProxy& proxy, Actions& actions);
    void send(WorkerProxy& proxy,
              DispatchJob& job,
              std::vector<std::uint64_t> scenarios,
              bool claims,
              Actions& actions);

    // ---- Ranges (dispatcher_ranges.cpp) ---------------------------------------------------------
    /// Of this event. What is sent meanwhile changes none of it.
    [[nodiscard]] const PlaceTotals& place_totals(const DispatchJob& job) const;
    /// At the start of an event, or where something else has changed.
    void forget_place_totals() const;
    /// Workers that would run dry get places.
    void give_places(Actions& actions);
    void give_places_to(WorkerProxy& proxy, Actions& actions);
    [[nodiscard]] DispatchJob* next_with_places(const WorkerProxy& proxy);
    [[nodiscard]] bool takes_places(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// One scenario would end there long after the others have done all that is left.
    [[nodiscard]] bool would_be_late(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// Scenarios of the job's ranges that the worker's threads do in a second.
    [[nodiscard]] double places_per_second(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] std::uint64_t places_at_once(const WorkerProxy& proxy,
                                               const DispatchJob& job) const;
    void send_places(WorkerProxy& proxy, DispatchJob& job, Actions& actions);
    /// Of the roots of both trees, what the worker does not hold.
    [[nodiscard]] double missing_share(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] double missing_with_any(const DispatchJob& job, const DispatchScenario& scenario);
    /// Before a worker holds the scenario: now and then notes what lacks.
    void measure_missing(DispatchJob& job, const DispatchScenario& scenario);
    /// Until the blocks are there.
    [[nodiscard]] double seconds_of(const WorkerPool::Missing& missing,
                                    const WorkerProxy& proxy) const;

    // ---- A free worker takes what is most similar (dispatcher_pull.cpp) -------------------------
    /// Some worker pulls a task's worth. False when none can.
    bool pull_one(DispatchJob& job, Actions& actions);
    [[nodiscard]] bool can_pull(const WorkerProxy& proxy, const DispatchJob& job) const;
    void pull(WorkerProxy& proxy, DispatchJob& job, Actions& actions);

    // ---- Matching by time (dispatcher_by_time.cpp) ----------------------------------------------
    [[nodiscard]] double speed_of(const WorkerProxy& proxy) const;
    [[nodiscard]] double link_of(const WorkerProxy& proxy) const;
    [[nodiscard]] WorkerPowers powers_of(const WorkerProxy& proxy) const;
    /// Predicted seconds that all its threads do in a second.
    [[nodiscard]] double power_of(const WorkerProxy& proxy) const;
    [[nodiscard]] bool takes_by_time(const WorkerProxy& proxy) const;
    /// The worker on which the scenario would be done first. Null: nobody takes any.
    [[nodiscard]] WorkerProxy* earliest(const DispatchJob& job, const DispatchScenario& scenario);
    [[nodiscard]] FinishTerms finish_on(const WorkerProxy& proxy,
                                        const DispatchJob& job,
                                        const DispatchScenario& scenario) const;
    /// Says to each worker how much goes to it together from now on.
    void set_batches();
    [[nodiscard]] bool has_room_by_time(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] bool runs_dry_by_time(const WorkerProxy& proxy) const;
    /// Its scenarios are so long that each is a batch, and all of them are known.
    [[nodiscard]] bool ends_with_long_ones(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// Unsent scenarios for the batches of all workers.
    [[nodiscard]] std::uint64_t enough_by_time() const;
    /// The first of a buffer, as much as goes together.
    [[nodiscard]] std::vector<std::uint64_t> take_batch(WorkerProxy& proxy, const DispatchJob& job);
    [[nodiscard]] ScenarioWeight sum_of_weights(const DispatchJob& job,
                                                std::span<const std::uint64_t> scenarios) const;
    /// Workers that run dry get what they would finish before those in whose buffers it is.
    void rebalance(Actions& actions);
    void add_backlog(std::vector<Backlog>& full, WorkerProxy& proxy) const;
    /// What `to` would finish sooner, until it has enough.
    void move(WorkerProxy& from, WorkerProxy& to);
    [[nodiscard]] bool move_one(WorkerProxy& from, WorkerProxy& to, DispatchJob& job);
    [[nodiscard]] bool
    move_if_earlier(WorkerProxy& from, WorkerProxy& to, DispatchJob& job, std::uint64_t index);

    // ---- The end of a job (dispatcher_end.cpp) --------------------------------------------------
    [[nodiscard]] bool nothing_waits() const;
    /// Workers that have nothing to do get what others would finish later.
    void help_at_end(Actions& actions);
    /// The mightiest first.
    [[nodiscard]] std::vector<WorkerProxy*> helpers() const;
    [[nodiscard]] bool can_help(const WorkerProxy& proxy) const;
    /// Seconds until it has done all that stands there.
    [[nodiscard]] double ends_in(const WorkerProxy& proxy) const;
    /// Those that others may help, who would end last first. Of many those that were not looked at
    /// for longest.
    [[nodiscard]] std::vector<WorkerProxy*> late_workers();
    /// It was asked back something, and may yet give it.
    [[nodiscard]] bool may_answer_recall(const WorkerProxy& proxy) const;
    /// It has something that can be asked back, or copied.
    [[nodiscard]] bool may_be_helped(const WorkerProxy& from) const;
    [[nodiscard]] bool can_be_copied(const ProxyTask& task) const;
    /// False: there is nothing that would be done sooner so.
    [[nodiscard]] bool helps(WorkerProxy& from, WorkerProxy& helper, Actions& actions);
    [[nodiscard]] bool ask_back(WorkerProxy& from, const WorkerProxy& helper, Actions& actions);
    [[nodiscard]] AskBack
    batch_to_ask(const WorkerProxy& from, TaskId task, const WorkerProxy& helper) const;
    [[nodiscard]] AskBack
    range_to_ask(const WorkerProxy& from, TaskId task, const WorkerProxy& helper) const;
    /// So many that both end together; 0 if one would not end so many times sooner.
    [[nodiscard]] std::uint64_t places_to_move(const WorkerProxy& from,
                                               const DispatchJob& job,
                                               const WorkerProxy& helper,
                                               double seconds_here,
                                               double gain) const;
    void take_recalled(WorkerProxy& proxy, const Recalled& recalled, Actions& actions);
    /// How many.
    std::uint64_t
    take_recalled_scenarios(WorkerProxy& proxy, DispatchJob& job, const Recalled& recalled);
    /// It leaves the task unanswered. True: it stays in its other one.
    static bool leave_task(DispatchScenario& scenario, TaskId task);
    [[nodiscard]] bool copy(WorkerProxy& from, WorkerProxy& helper, Actions& actions);
    [[nodiscard]] bool
    copy_scenario(WorkerProxy& from, TaskId task, WorkerProxy& helper, Actions& actions);
    [[nodiscard]] bool
    copy_places(WorkerProxy& from, TaskId task, WorkerProxy& helper, Actions& actions);
    /// So much more may be done twice.
    [[nodiscard]] static std::uint64_t copies_left_ns(const DispatchJob& job);

    // ---- Explaining (dispatcher_explain.cpp) ----------------------------------------------------
    [[nodiscard]] std::string whereabouts(const DispatchJob& job, std::uint64_t index) const;
    [[nodiscard]] WorkerScore score_of(const WorkerProxy& proxy,
                                       const DispatchJob& job,
                                       const DispatchScenario& scenario) const;
    [[nodiscard]] bool may_take(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// Of those that may take it; its id is that of no worker where workers choose, or none may.
    [[nodiscard]] WorkerId would_choose(DispatchJob& job, const DispatchScenario& scenario);

    // ---- Taking back ----------------------------------------------------------------------------
    /// Buffered scenarios wait again, first in line.
    void take_back_buffers(WorkerProxy& proxy);
    /// The scenario, which no worker has, has been lost so often that it is given up.
    [[nodiscard]] static bool is_lost_for_good(const DispatchScenario& scenario);
    /// Whether the next loss would be the last: then it stands among the suspects.
    bool suspect(JobId job, std::uint64_t index, DispatchScenario& scenario);
    /// Scenarios of an ended task without answers wait again; where they are lost, some are
    /// suspected or given up.
    void take_back(TaskId task, const ProxyTask& ended, LostWith lost_with, Actions& actions);
    /// What of the task, which has ended, is not answered has to be done again.
    void end_task(TaskId task, const ProxyTask& ended, LostWith lost_with, Actions& actions);
    /// Removes the scenario from where it is; its entry stays. Who else has a copy is told.
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
