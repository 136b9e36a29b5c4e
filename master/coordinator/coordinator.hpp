// Drives the dispatcher: carries events to it from sessions and jobs, and its actions out.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/core/limits/master.hpp"
#include "master/blocks/block_delivery.hpp"
#include "master/blocks/transfer_meter.hpp"
#include "master/coordinator/job_board.hpp"
#include "master/dispatch/dispatcher.hpp"
#include "master/geometry/geometry_store.hpp"
#include "master/geometry/tree_registry.hpp"
#include "master/jobs/job_spool.hpp"
#include "master/journal/journal.hpp"
#include "master/journal/ledger.hpp"
#include "master/results/late_results.hpp"
#include "master/workers/awaited_workers.hpp"
#include "master/workers/worker_sessions.hpp"
#include "master/workers/worker_watch.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"

#include <atomic>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace cd {

struct JobGeometry;

/// The parts that the coordinator uses; all of them outlive it.
struct CoordinatorParts {
    asio::any_io_executor executor; ///< Its one thread owns all state.
    GeometryStore& geometry;
    ThreadPool& compute;  ///< Analysis, and the checking of results.
    ThreadPool& blocking; ///< For work that waits for the disk or `compute`.
    /// Not started. Ends before the executor's context does, and after the coordinator.
    Journal& journal;
    std::filesystem::path directory; ///< Where arriving poses are spooled.
    Durability durability = Durability::Synced;
    FailureTimes times;
    std::uint64_t results_aside_bytes_max = limits::results_aside_bytes_max;
    JobRetention retention = {};
};

/// How a worker's Hello is answered.
struct Reception {
    WorkerId worker;
    PeerKey key;
    bool is_resumed = false; ///< Its earlier session is resumed.
};

/// Messages of results of one worker's process that are being checked or wait for the journal, over
/// all of its connections and sessions: a process that connects again gets no second allowance.
struct WorkerIntake {
    std::size_t messages = 0;
    std::function<void()> has_room = {}; ///< Called when one has gone.
};

/// All jobs and all workers. Every member runs on the executor's thread.
class Coordinator {
  public:
    /// Call `restore` before anything else.
    explicit Coordinator(CoordinatorParts parts);
    Coordinator(const Coordinator&) = delete;
    Coordinator& operator=(const Coordinator&) = delete;
    ~Coordinator();

    /// Resumes the jobs that the journal holds and starts the journal. Blocks for the disk. Errors:
    /// Io, naming a file of poses that is damaged.
    [[nodiscard]] Status restore(Recovered recovered);
    [[nodiscard]] const Sha256& cluster() const { return cluster_; }

    [[nodiscard]] const asio::any_io_executor& executor() const { return parts_.executor; }
    [[nodiscard]] GeometryStore& geometry() { return parts_.geometry; }
    [[nodiscard]] ThreadPool& blocking() { return parts_.blocking; }
    [[nodiscard]] const Journal& journal() const { return parts_.journal; }
    [[nodiscard]] const std::filesystem::path& directory() const { return parts_.directory; }

    // ---- Workers (coordinator_workers.cpp) ------------------------------------------------------
    [[nodiscard]] const FailureTimes& times() const { return parts_.times; }
    [[nodiscard]] std::uint64_t epoch() const { return epoch_; }
    /// Decides how to answer a Hello. Resumes the session if this master process created it and has
    /// not declared the worker lost.
    [[nodiscard]] Reception receive_worker(const Hello& hello);
    /// The Welcome has been sent. A new worker gets work at once, one that returns after its
    /// Standing.
    void
    worker_joined(const Reception& reception, const Hello& hello, std::shared_ptr<Channel> channel);
    /// A message of any type came. False: the worker has another connection by now, or is lost.
    [[nodiscard]] bool worker_heard(WorkerId worker, const Channel& channel);
    /// The master reads no messages of the worker for now, so silence does not count against it.
    void worker_unheard(WorkerId worker, const Channel& channel);
    /// The connection has ended, which is not a death; nothing happens if the worker has another
    /// one meanwhile.
    void connection_ended(WorkerId worker, const Channel& channel, const std::string& why);
    void heartbeat_came(WorkerId worker, const Heartbeat& heartbeat);
    void worker_stands(WorkerId worker, const Standing& standing);
    /// Stops all timers: the master ends.
    void close();
    void evicted(WorkerId worker, const Evicted& evicted);
    void cuts_held(WorkerId worker, const Holding& holding);
    void blocks_wanted(WorkerId worker, const WantSubtrees& want);
    void blocks_held(WorkerId worker, const Held& held);
    void peer_failed(WorkerId worker, const FetchFailed& failed);
    /// The intake of the worker's process.
    [[nodiscard]] std::shared_ptr<WorkerIntake> intake_of(WorkerId worker);
    /// Checks the results on the pool and merges them; then calls `done`, when the journal has room
    /// for more. They are acknowledged once they are durable. A worker whose results are invalid is
    /// cut off.
    void results_came(WorkerId worker, Results results, std::function<void()> done);
    void task_ended(WorkerId worker, TaskId task);
    void task_recalled(WorkerId worker, const Recalled& recalled);
    /// The worker takes no new work and leaves when it has finished what it has.
    void worker_draining(WorkerId worker);
    /// Cuts off a worker that does not keep to the protocol.
    void cut_off(WorkerId worker, const Error& why);
    /// The workers that have not left and are not lost, ascending.
    [[nodiscard]] std::vector<WorkerId> workers_here() const;
    /// Tells a worker that is here to hand over what it has and to leave.
    void drain_worker(WorkerId worker);
    /// Tells a worker that is here to end at once. Its work goes to others, and does not count as
    /// lost.
    void terminate_worker(WorkerId worker);

    // ---- Explanations (coordinator_explain.cpp) -------------------------------------------------
    /// Scores the workers for a scenario as of now. For a job that has ended it tells only who
    /// answered. Errors: NotFound; Refused while the job is being prepared; Io when the poses
    /// cannot be read.
    [[nodiscard]] asio::awaitable<Result<Explained>> explain(JobId job, std::uint64_t scenario);
    /// Explains an analysed scenario of a running job. Errors: NotFound; Refused unless the job
    /// runs.
    [[nodiscard]] Result<Explained> explain(JobId job, Analysis analysis);
    /// The input to analyse one of the job's scenarios. Errors: NotFound; Refused unless the job
    /// runs.
    [[nodiscard]] Result<AnalysisInput> analysis_input(JobId job);

    // ---- Jobs (coordinator_jobs.cpp) ------------------------------------------------------------
    /// Opens a job whose submission has been checked; `poses` are complete, or null with a grid.
    /// Returns when the job is in the journal. Errors: Refused; Io.
    [[nodiscard]] asio::awaitable<Result<JobId>> open_job(Submit submit,
                                                          std::shared_ptr<JobSpool> poses);
    /// Cancels the job and returns when the journal has it. Does nothing if the job has ended.
    /// Errors: NotFound.
    [[nodiscard]] asio::awaitable<Result<JobStatus>> cancel_job(JobId job);
    /// Forgets a job that has ended. Returns when the journal has forgotten it; then its files go.
    /// Errors: NotFound; Refused while it runs; Io when the journal does not write.
    [[nodiscard]] asio::awaitable<Status> forget_job(JobId job);
    /// Forgets the jobs whose retention is over. `now` is in seconds since 1970.
    void forget_expired_jobs(std::uint64_t now);
    /// Fails the scenario and stops it wherever it runs; the job goes on. Errors: NotFound; Refused
    /// when it has a result that is not in dispute.
    [[nodiscard]] asio::awaitable<Result<JobStatus>> cancel_scenario(JobId job,
                                                                     std::uint64_t scenario);
    /// Errors: NotFound.
    [[nodiscard]] Result<JobStatus> job_status(JobId job);
    /// Grows when the status of the job changes; 0 for no job.
    [[nodiscard]] std::uint64_t job_changes(JobId job);
    /// Cancels the timer when the job has ended, or is forgotten, if it still exists.
    void notify_at_end(JobId job, const std::shared_ptr<asio::steady_timer>& timer);
    /// Null for no job.
    [[nodiscard]] std::shared_ptr<ResultStore> results_of(JobId job);
    /// Errors: NotFound; Refused for a job that is not done.
    [[nodiscard]] Result<ContactMapAnswer> contact_map(JobId job);
    [[nodiscard]] ClusterStatus cluster_status();
    /// Why nothing can be accepted or acknowledged now; empty if it can.
    [[nodiscard]] const std::string& paused() const { return paused_; }

    /// The processes of workers that were found wrong, and how many alarms there were, in all
    /// lives.
    [[nodiscard]] const std::set<std::uint64_t>& quarantined() const { return quarantined_; }
    [[nodiscard]] std::uint64_t alarm_count() const { return alarms_.count; }

    /// Aborts when an invariant is broken; for tests, between two events.
    void check_invariants() const;
    /// The blocks that other workers may fetch from this one: none if it has no connection, or has
    /// not sent its Standing. For tests, as above.
    [[nodiscard]] std::set<BlockKey> blocks_held_by(WorkerId worker) const;

  private:
    struct WorkerLink {
        std::shared_ptr<Channel> channel; ///< Closed, between two connections.
        PeerKey key;
        std::string name;
        bool is_settled = true;         ///< The master knows what the worker has.
        bool is_cut_off = false;        ///< It may not resume its session.
        bool is_dismissed = false;      ///< It was told to end at once.
        std::uint64_t results_last = 0; ///< The greatest number of its messages of results so far.
        std::uint64_t bytes_seen = 0;   ///< Received on its connection at the last check.
        std::optional<RunningScenario> longest;
        std::uint64_t cache_bytes = 0;
        std::uint64_t cached_bytes = 0;
        std::uint32_t threads = 1;
        std::set<TreeId> trees; ///< Sent to the worker (AddTree).
        std::set<JobId> jobs;   ///< Sent to the worker (AddJob).
        std::uint64_t instance = 0;
        bool quarantined = false;
        std::set<Sha256> cuts; ///< Cuts whose blocks it kept from an earlier session.
        CacheTraffic cache;
        TransferMeter transfers;
        Clock::duration busy{}; ///< Time with work, before `busy_since`.
        std::optional<Clock::time_point> busy_since;
    };
    struct LostWorker {
        WorkerStatus status; ///< At the moment of its loss.
        std::uint64_t instance = 0;
    };
    struct RunningTask {
        WorkerId worker;
        std::shared_ptr<const TaskContent> content;
        std::size_t in_hand = 0;               ///< Messages of results that are being checked.
        bool ended = false;                    ///< The worker has sent all its results.
        bool unbegun = false;                  ///< It never reached the worker.
        bool is_called_off = false;            ///< For ranges: some answers are not owed.
        bool is_copy = false;                  ///< Another worker has the same work.
        std::optional<PlaceRange> places = {}; ///< For ranges: the places not given back.
    };
    /// Results of no task: of an earlier session, or of a job that has ended.
    struct LateResults {
        WorkerId worker;
        std::shared_ptr<const Results> message;
        std::function<void()> done;
    };
    /// Results that have been checked.
    struct ResultsInHand {
        WorkerId worker;
        std::shared_ptr<const TaskContent> task; ///< Null for what came late.
        std::shared_ptr<const Results> message;
        Result<TakenResults> taken;
        std::function<void()> done;
        std::vector<std::uint64_t> mapped; ///< The map was made again of these only.
    };

    // Workers.
    void worker_returned(WorkerId worker, std::shared_ptr<Channel> channel);
    /// The worker is gone for good, and its work goes to others.
    void worker_left(WorkerId worker, const std::string& why);
    void worker_lost(WorkerId worker, const std::string& why);
    [[nodiscard]] bool is_its_channel(WorkerId worker, const Channel& channel) const;
    /// Returns the unanswered work of its tasks to the queue without counting it as lost, and gives
    /// it no more work.
    void take_all_back(WorkerId worker);
    /// Ends the earlier sessions of a process that has begun a new one.
    void end_earlier_sessions(std::uint64_t instance);
    [[nodiscard]] Status check_standing(const Standing& standing) const;
    asio::awaitable<void> watch_workers();
    void check_workers();
    void hear_bytes();
    void note_life(WorkerId worker);
    void take_lost_trees(WorkerId worker, WorkerLink& link, const Standing& standing);
    void take_lost_jobs(WorkerLink& link, const Standing& standing);
    void take_lost_tasks(WorkerId worker, const Standing& standing);
    void forget_tasks(WorkerId worker);
    /// `task` is null for late results. False: the job has ended, and the results are still to be
    /// compared with the stored ones.
    [[nodiscard]] bool results_taken(WorkerId worker,
                                     const TaskContent* task,
                                     const Results& results,
                                     Result<TakenResults> taken);
    void take_in(std::shared_ptr<ResultsInHand> hand);
    /// The scenarios of those results that are not merged.
    [[nodiscard]] static std::vector<std::uint64_t>
    new_scenarios(const MasterJob& job, std::span<const TakenResult> results);
    /// Recomputes the contact map for `scenarios` only, then takes the results in.
    asio::awaitable<void>
    make_map(JobId job, std::shared_ptr<ResultsInHand> hand, std::vector<std::uint64_t> scenarios);
    void withdraw_map(MasterJob& job, const std::string& why);
    /// A message with this number has come before, so its times are not measured again.
    [[nodiscard]] bool is_repeated(WorkerId worker, std::uint64_t sequence);

    // Results of no task (coordinator_late.cpp).
    /// Results wait for the disk or for their job. As long as there is room for them their worker
    /// goes on with others; else it is not listened to. Ends with `take_up`.
    void set_aside(const Results& message, std::function<void()>& done);
    void take_up(const Results& message);
    void late_results_came(LateResults late);
    void put_away(LateResults late);
    void forget_late_results(WorkerId worker);
    [[nodiscard]] bool has_late_results(JobId job) const;
    /// Resumes late results that waited for the job's geometry, or for its end to be durable.
    void look_at_late_results(JobId job);
    void check_late_results(const MasterJob& job, LateResults late);
    void late_results_checked(std::shared_ptr<ResultsInHand> hand);
    /// `kept` holds the results of the job, which has ended.
    asio::awaitable<void> compare_late_results(LateResults late,
                                               std::shared_ptr<const ResultStore> kept);
    /// Acknowledges late results that need no more work.
    void finish(const LateResults& late);
    struct EndedRun;
    struct LateCase {
        LateResults late;
        LateDifference difference;
    };
    asio::awaitable<void> judge_late_cases();
    /// Judges a late result by the master's own run of the scenario.
    void judge(const LateCase& late, const Result<ScenarioResult>& right);
    void add_held_trees(WorkerLink& link);
    void end_task_if_complete(TaskId task);
    /// Cancels duplicate copies of `scenario` on all workers except `worker`.
    void call_off_places(const MasterJob& job, WorkerId worker, std::uint64_t scenario);
    void add_job_to(WorkerLink& link, const MasterJob& job);
    void add_tree_to(WorkerLink& link, TreeId tree);
    void note_work(WorkerId worker);
    [[nodiscard]] WorkerStatus worker_status(WorkerId worker, const WorkerLink& link) const;

    // Jobs.
    asio::awaitable<void> prepare_job(JobId job);
    void start_job(MasterJob& job, const JobGeometry& made);
    /// Makes the job's submitter. It passes over the scenarios that have a result by now: after a
    /// restart also those that workers have brought back.
    void begin_analysis(MasterJob& job);
    void block_came(JobId job, AnalysedBlock block, std::vector<TakenResult> finished);
    /// The only place where results enter a job, and the journal. `worker`: who computed them; 0 is
    /// the master.
    void merge(MasterJob& job, TakenResults taken, WorkerId worker);
    /// False: it is not the first result of its scenario.
    [[nodiscard]] bool
    merge_one(MasterJob& job, const TakenResult& taken, WorkerId worker, AddResults& add);
    void end_if_complete(MasterJob& job);
    /// Holds back resumed jobs until the workers from before the restart have returned.
    void await_workers();
    asio::awaitable<void> end_waiting(std::shared_ptr<asio::steady_timer> timer);
    /// Frees the analysis of a scenario that has a result.
    void close_analysis(MasterJob& job, std::uint64_t scenario);
    void fail_scenario(MasterJob& job, const Scenario& scenario, const std::string& why);

    // Jobs that wait for the disk (coordinator_pauses.cpp).
    /// Sets why the job is paused; empty if it is not.
    void job_paused(MasterJob& job, const std::string& why);
    /// Pauses the job after an error of the disk, and calls `again` a little later. Until then no
    /// more of its work is prepared. Any other error fails the job.
    void wait_for_disk(MasterJob& job, const Error& why, std::function<void()> again);
    using DiskWaits = std::multimap<JobId, std::shared_ptr<asio::steady_timer>>;
    using DiskWait = DiskWaits::iterator;
    /// Pauses the job like `wait_for_disk`, in a coroutine. Null: the job or the master has ended.
    asio::awaitable<MasterJob*> wait_until_mended(JobId job, Error why);
    asio::awaitable<void> try_again(std::optional<DiskWait> wait, std::function<void()> again);
    /// Empty if there is nothing to wait for.
    std::optional<DiskWait> begin_to_wait(MasterJob& job, const Error& why);
    asio::awaitable<MasterJob*> end_of_wait(DiskWait wait);
    /// The disk works again for the job.
    void disk_gives(MasterJob& job);
    /// Drops all waits of a job that ends.
    void stop_waiting(JobId job);
    void add_what_it_waits_for(JobStatus& job) const;

    // Explaining.
    [[nodiscard]] Explained explain_ended(const MasterJob& job, std::uint64_t scenario) const;
    [[nodiscard]] std::string
    answered_by(const MasterJob& job, std::uint64_t scenario, bool needs_worker) const;

    // Results that differ (coordinator_disputes.cpp).
    struct Evidence;
    /// Records the dispute in `add`, which is written next. When it is on the disk, the master's
    /// own result decides the dispute.
    void open_dispute(MasterJob& job, const Dispute& dispute, AddResults& add);
    asio::awaitable<void> settle_dispute(Dispute dispute);
    /// Without evidence the first result stands.
    void settle(MasterJob& job, const Dispute& dispute, std::optional<Evidence> evidence);
    /// Adds the consequences for the journal to `verdict`. Errors: TooLarge when the right result
    /// is too large.
    [[nodiscard]] Status
    judge(MasterJob& job, const Dispute& dispute, Evidence evidence, AddResults& verdict);
    /// Replaces the wrong merged result of a scenario. `why` is the reason that the job loses its
    /// map.
    void correct(MasterJob& job,
                 TakenResult right,
                 const ScenarioFacts& wrong,
                 const std::string& why,
                 AddResults& verdict);
    /// Stops the runs that settle disputes of the job, or of one of its scenarios. False if there
    /// are none.
    bool stop_judging(JobId job, std::optional<std::uint64_t> scenario);
    void alarm(const std::string& text);

    // Who was wrong, and what else may be (coordinator_doubts.cpp).
    void quarantine(WorkerId worker);
    [[nodiscard]] bool is_quarantined(WorkerId worker) const;
    /// The worker's results are not taken: it, or the holder of its certificate, is in quarantine.
    [[nodiscard]] bool is_distrusted(WorkerId worker) const;
    /// A holder of whom one process was wrong is not trusted with the next one either.
    [[nodiscard]] bool is_holder_quarantined(const std::string& holder) const;
    void quarantine_holder(WorkerId worker);
    /// A name for people; also for a worker that only an earlier master process knew.
    [[nodiscard]] std::string name_of(WorkerId worker) const;
    /// A worker id for a process from before the restart.
    [[nodiscard]] WorkerId earlier_worker(WorkerProcess process);
    /// Restores authors, doubts and disputes from before the restart.
    void restore_authors(MasterJob& job,
                         std::span<const std::uint64_t> done,
                         std::span<const WorkerProcess> authors,
                         std::span<const Remark> disputes);
    /// The geometry of the job is there.
    void take_up_doubts(MasterJob& job);
    /// Has other workers repeat all scenarios that this one has answered.
    void doubt_results_of(WorkerId worker);
    void doubt(MasterJob& job, const std::vector<std::uint64_t>& scenarios);
    /// The geometry of the job is there.
    void answer_again(MasterJob& job, std::span<const std::uint64_t> scenarios);
    void do_again(MasterJob& job, std::vector<std::uint64_t> places);
    /// False if the scenario was not in doubt.
    bool doubt_ends(MasterJob& job, std::uint64_t scenario, WorkerId by);
    /// Fails a doubted scenario that was lost with too many workers: to judge it, the master would
    /// have to run it.
    void give_up_doubt(MasterJob& job, const Scenario& scenario, const std::string& why);
    asio::awaitable<void> fail_doubted(JobId job, Scenario scenario, std::string why);
    /// Drops sessions of departed workers that no running job's results refer to.
    void forget_sessions();

    void end_job(MasterJob& job, JobState state, const std::string& failure);
    void release_tree(TreeId tree);

    // What is handed out next (coordinator_feed.cpp).
    /// Asks for more analyses where there is room for them, and gives places; tells the dispatcher
    /// when nothing comes.
    void feed();
    [[nodiscard]] bool has_room_for_analysis(std::uint64_t under_way) const;
    [[nodiscard]] bool prefers_ranges_now(const MasterJob& job) const;
    /// Gives the job's next places to the dispatcher until that has enough.
    void give_places(MasterJob& job);
    void places_came(JobId job,
                     const PlaceRange& places,
                     const Result<std::shared_ptr<const PoseWindow>>& window);
    void give_unmerged(MasterJob& job, const GivenPlaces& given);
    void take_places_back(MasterJob& job);
    /// Queues those of the places again that have no result and are in no task.
    void give_again(MasterJob& job, const GivenPlaces& ended, LostWith lost_with);
    /// Keeps the losses of scenarios, so that one that kills workers is not tried from the start
    /// after a restart.
    void write_losses(MasterJob& job, std::vector<LostPlaces> losses);
    /// The places whose scenarios have no result.
    [[nodiscard]] static std::vector<PlaceRange> unmerged(const MasterJob& job,
                                                          const GivenPlaces& given);

    /// Seconds since a fixed point in time.
    [[nodiscard]] double now() const;
    // What is durable (coordinator_journal.cpp).
    [[nodiscard]] JournalEvents journal_events();
    std::uint64_t write(JournalEntry entry);
    void journal_committed(std::uint64_t position);
    [[nodiscard]] bool journal_has_room() const;
    void keep_promises();
    void job_ended(JobId job);
    void wake_waiting(JobId job);
    /// Deletes the record of a job that has left the board, and then its files.
    void drop_from_journal(JobId job);
    /// Calls `done` now, or when the journal has room.
    void go_on(std::function<void()> done);
    [[nodiscard]] JobStatus status_of(const MasterJob& job) const;

    // What is always true (coordinator_invariants.cpp).
    void check_leases() const;
    void check_job(const MasterJob& job) const;
    /// Scenarios that wait or run in ranges.
    [[nodiscard]] std::vector<bool> scenarios_in_ranges(const MasterJob& job) const;

    /// The dispatcher, told what time it is.
    [[nodiscard]] Dispatcher& dispatcher();
    // The dispatcher's actions.
    void act(Actions actions);
    void perform(const SendBatch& batch);
    void perform(const GiveUp& action);
    void perform(const SendRange& range);
    void perform(const RangeEnded& ended);
    void perform(const ScenariosLost& lost);
    void perform(const AskBack& ask);
    void perform(const GivenBack& given);
    void perform(const CallOff& loser);
    void perform(const SendHint& hint);

    CoordinatorParts parts_;
    Clock::time_point started_ = Clock::now();
    Dispatcher dispatcher_;
    std::deque<Action> actions_;
    bool acting_ = false;
    std::map<WorkerId, WorkerLink> workers_;
    std::uint64_t worker_last_ = 0;
    std::uint64_t epoch_; ///< Identifies this master process.
    WorkerWatch watch_;
    std::map<WorkerId, LostWorker> lost_;             ///< Kept for a while for `status`.
    std::shared_ptr<asio::steady_timer> watch_timer_; ///< Null while nobody is watched.
    bool closed_ = false;
    /// The same, for other threads.
    std::shared_ptr<std::atomic<bool>> closing_ = std::make_shared<std::atomic<bool>>(false);
    std::uint64_t workers_lost_ = 0;
    std::uint64_t sessions_resumed_ = 0;
    std::uint64_t scenarios_given_back_ = 0;
    std::map<TaskId, RunningTask> tasks_;
    TreeRegistry trees_;
    BlockDelivery blocks_;
    JobBoard jobs_;
    JobId fed_last_;
    std::uint64_t open_bytes_ = 0; ///< Of all jobs' open analyses.
    std::multimap<JobId, std::weak_ptr<asio::steady_timer>> waiting_for_end_;
    Ledger ledger_;
    Sha256 cluster_;
    std::uint64_t written_ = 0; ///< The position of the last entry.
    std::string paused_;        ///< Why the journal does not write; or empty.
    std::map<JobId, std::shared_ptr<asio::steady_timer>> waiting_for_acceptance_;
    DiskWaits retries_;                                         ///< Of jobs paused by the disk.
    using LateKey = std::tuple<JobId, WorkerId, std::uint64_t>; ///< With the message's number.
    std::map<LateKey, LateResults> late_results_;               ///< Not examined yet.
    std::uint64_t aside_bytes_ = 0;                             ///< Of all `late_results_`.
    std::deque<LateCase> late_cases_;                           ///< The first is being judged.
    std::vector<std::function<void()>> waiting_for_room_;       ///< In the journal.
    AlarmRecord alarms_;
    std::set<WorkerProcess> quarantined_; ///< Those of the alarms, holders among them.
    WorkerSessions sessions_;
    std::map<WorkerProcess, std::weak_ptr<WorkerIntake>> intakes_;
    /// The runs that settle disputes, by job and scenario; setting the flag stops them.
    using Judging =
        std::multimap<std::pair<JobId, std::uint64_t>, std::shared_ptr<std::atomic<bool>>>;
    Judging judging_;
    AwaitedWorkers awaited_;
    std::shared_ptr<asio::steady_timer> awaited_until_; ///< Null if no worker is awaited.
};

} // namespace cd
