// Drives the dispatcher: carries events to it from sessions and jobs, and its actions out.
#pragma once

#include "common/core/limits_master.hpp"
#include "common/core/thread_pool.hpp"
#include "master/awaited_workers.hpp"
#include "master/block_delivery.hpp"
#include "master/dispatcher.hpp"
#include "master/geometry_store.hpp"
#include "master/job_board.hpp"
#include "master/job_spool.hpp"
#include "master/journal.hpp"
#include "master/late_results.hpp"
#include "master/ledger.hpp"
#include "master/transfer_meter.hpp"
#include "master/tree_registry.hpp"
#include "master/worker_sessions.hpp"
#include "master/worker_watch.hpp"
#include "proto/asio.hpp"
#include "proto/channel.hpp"

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

/// What the coordinator works with; all of it outlives the coordinator.
struct CoordinatorParts {
    asio::any_io_executor executor; ///< Its one thread owns all state.
    GeometryStore& geometry;
    ThreadPool& compute;  ///< Analysis, and the checking of results.
    ThreadPool& blocking; ///< For what waits for the disk or for `compute`.
    /// Not started. Ends before the executor's context does, and after the coordinator.
    Journal& journal;
    std::filesystem::path directory; ///< Of the poses that come.
    Durability durability = Durability::Synced;
    FailureTimes times;
    std::uint64_t results_aside_bytes_max = limits::results_aside_bytes_max;
    JobRetention retention = {};
};

/// How a worker is let in.
struct Reception {
    WorkerId worker;
    PeerKey key;
    bool is_resumed = false; ///< Its session goes on.
};

/// Messages of results of one worker's process that are being checked or wait for the journal, over
/// all of its connections and sessions: who connects again has no more of them.
struct WorkerIntake {
    std::size_t messages = 0;
    std::function<void()> has_room = {}; ///< Called when one has gone.
};

/// All jobs and all workers. Every member runs on the executor's thread.
class Coordinator {
  public:
    /// Goes on with the jobs that the journal holds. Call `restore` before anything else.
    explicit Coordinator(CoordinatorParts parts);
    Coordinator(const Coordinator&) = delete;
    Coordinator& operator=(const Coordinator&) = delete;
    ~Coordinator();

    /// Takes the jobs of earlier lives over, and starts the journal. Blocks for the disk. Errors:
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
    /// To be welcomed so. A session goes on if it is of this life of the master, and the worker not
    /// lost since.
    [[nodiscard]] Reception receive_worker(const Hello& hello);
    /// The worker has been welcomed. A new one gets work at once; one that comes back, when it has
    /// said how it stands.
    void
    worker_joined(const Reception& reception, const Hello& hello, std::shared_ptr<Channel> channel);
    /// It speaks, whatever it says. False: it has another connection meanwhile, or is lost.
    [[nodiscard]] bool worker_heard(WorkerId worker, const Channel& channel);
    /// It is not listened to for now.
    void worker_unheard(WorkerId worker, const Channel& channel);
    /// The connection has ended, which is not a death; nothing happens if the worker has another
    /// one meanwhile.
    void connection_ended(WorkerId worker, const Channel& channel, const std::string& why);
    void heartbeat_came(WorkerId worker, const Heartbeat& heartbeat);
    void worker_stands(WorkerId worker, const Standing& standing);
    /// No worker is watched any more: all ends.
    void close();
    void evicted(WorkerId worker, const Evicted& evicted);
    void cuts_held(WorkerId worker, const Holding& holding);
    void blocks_wanted(WorkerId worker, const WantSubtrees& want);
    void blocks_held(WorkerId worker, const Held& held);
    void peer_failed(WorkerId worker, const FetchFailed& failed);
    /// That of the worker's process.
    [[nodiscard]] std::shared_ptr<WorkerIntake> intake_of(WorkerId worker);
    /// Checks the results on the pool and merges them; then calls `done`, when the journal has room
    /// for more. They are acknowledged once they are durable. A worker whose results are none is
    /// cut off.
    void results_came(WorkerId worker, Results results, std::function<void()> done);
    void task_ended(WorkerId worker, TaskId task);
    void task_recalled(WorkerId worker, const Recalled& recalled);
    /// The worker takes no more, and leaves when it has finished what it has.
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

    // ---- How workers score (coordinator_explain.cpp) --------------------------------------------
    /// For the scenario, as things stand now. Of a job that has ended it is analysed again. Errors:
    /// NotFound, also of meshes or poses that are gone; Refused while the job is being prepared.
    [[nodiscard]] asio::awaitable<Result<Explained>> explain(JobId job, std::uint64_t scenario);
    /// For one that has been analysed. Errors: NotFound; Refused unless the job runs.
    [[nodiscard]] Result<Explained> explain(JobId job, Analysis analysis);
    /// To analyse one of the job's scenarios with. The same errors.
    [[nodiscard]] Result<AnalysisInput> analysis_input(JobId job);

    // ---- Jobs (coordinator_jobs.cpp)
    // --------------------------------------------------------------
    /// The submission has been checked, and the poses are complete; none with a grid. Returns when
    /// the job is in the journal. Errors: Refused; Io.
    [[nodiscard]] asio::awaitable<Result<JobId>> open_job(Submit submit,
                                                          std::shared_ptr<JobSpool> poses);
    /// Returns when that is in the journal. Nothing to do for a job that has ended. Errors:
    /// NotFound.
    [[nodiscard]] asio::awaitable<Result<JobStatus>> cancel_job(JobId job);
    /// Forgets a job that has ended; its files go when the journal has forgotten it. Returns then.
    /// Errors: NotFound; Refused while it runs; Io when the journal does not write.
    [[nodiscard]] asio::awaitable<Status> forget_job(JobId job);
    /// Forgets the jobs that are kept no longer. `now` is in seconds since 1970.
    void forget_expired_jobs(std::uint64_t now);
    /// The scenario fails, and whoever runs it stops; the job goes on. Errors: NotFound; Refused
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
    /// Why nothing can be accepted or acknowledged now; empty: it can.
    [[nodiscard]] const std::string& paused() const { return paused_; }

    /// The processes of workers that were found wrong, and how many alarms there were, in all
    /// lives.
    [[nodiscard]] const std::set<std::uint64_t>& quarantined() const { return quarantined_; }
    [[nodiscard]] std::uint64_t alarm_count() const { return alarms_.count; }

    /// Aborts when an invariant is broken; for tests, between two events.
    void check_invariants() const;
    /// What others may be sent to the worker for. Nothing of one that has no connection, or has not
    /// said how it stands. For tests, the same.
    [[nodiscard]] std::set<BlockKey> blocks_held_by(WorkerId worker) const;

  private:
    struct WorkerLink {
        std::shared_ptr<Channel> channel; ///< Closed, between two connections.
        PeerKey key;
        std::string name;
        bool is_settled = true;         ///< What it has is known: nothing that was sent got lost.
        bool is_cut_off = false;        ///< It has no session to come back to.
        bool is_dismissed = false;      ///< It was told to end at once.
        std::uint64_t results_last = 0; ///< The greatest number of its messages of results so far.
        std::uint64_t bytes_seen = 0;   ///< Of its connection, when time was looked at last.
        std::optional<RunningScenario> longest;
        std::uint64_t cache_bytes = 0;
        std::uint64_t cached_bytes = 0;
        std::uint32_t threads = 1;
        std::set<TreeId> trees; ///< That it has been told of,
        std::set<JobId> jobs;   ///< and jobs.
        std::uint64_t instance = 0;
        bool quarantined = false;
        std::set<Sha256> cuts; ///< Of which it kept blocks from a session before.
        CacheTraffic cache;
        TransferMeter transfers;
        Clock::duration busy{}; ///< With something to do, before `busy_since`.
        std::optional<Clock::time_point> busy_since;
    };
    struct LostWorker {
        WorkerStatus status; ///< As it was.
        std::uint64_t instance = 0;
    };
    struct RunningTask {
        WorkerId worker;
        std::shared_ptr<const TaskContent> content;
        std::size_t in_hand = 0;               ///< Messages of results that are being checked.
        bool ended = false;                    ///< The worker says that it has sent all.
        bool unbegun = false;                  ///< It got lost on its way to the worker.
        bool is_called_off = false;            ///< Of a range, some at least: no answer is owed.
        bool is_copy = false;                  ///< Another worker has the same.
        std::optional<PlaceRange> places = {}; ///< Of a range: what was not given back.
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
        std::vector<std::uint64_t> mapped; ///< Of these alone the map was made again; or none.
    };

    // Workers.
    void worker_returned(WorkerId worker, std::shared_ptr<Channel> channel);
    /// It is gone for good, and what it had goes to others.
    void worker_left(WorkerId worker, const std::string& why);
    void worker_lost(WorkerId worker, const std::string& why);
    [[nodiscard]] bool is_its_channel(WorkerId worker, const Channel& channel) const;
    /// Whatever of its tasks is not answered is still to be done, and does not count as lost. It
    /// gets nothing any more.
    void take_all_back(WorkerId worker);
    /// Of a process that is back, whatever it was before.
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
    /// `task`: null for what came late. False: the job has ended, and they are still to be compared
    /// with what was kept.
    [[nodiscard]] bool results_taken(WorkerId worker,
                                     const TaskContent* task,
                                     const Results& results,
                                     Result<TakenResults> taken);
    void take_in(std::shared_ptr<ResultsInHand> hand);
    /// Those of the results that are not merged.
    [[nodiscard]] static std::vector<std::uint64_t>
    new_scenarios(const MasterJob& job, std::span<const TakenResult> results);
    /// Of these scenarios instead of all that are in hand; then takes it in.
    asio::awaitable<void>
    make_map(JobId job, std::shared_ptr<ResultsInHand> hand, std::vector<std::uint64_t> scenarios);
    void withdraw_map(MasterJob& job, const std::string& why);
    /// A message of that number has come before: it is no measure of anything.
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
    /// Those that waited for the job's geometry, or for its end to be durable.
    void look_at_late_results(JobId job);
    void check_late_results(const MasterJob& job, LateResults late);
    void late_results_checked(std::shared_ptr<ResultsInHand> hand);
    /// `kept`: of the job, which has ended.
    asio::awaitable<void> compare_late_results(LateResults late,
                                               std::shared_ptr<const ResultStore> kept);
    /// There is nothing more to do with them.
    void finish(const LateResults& late);
    struct EndedRun;
    struct LateCase {
        LateResults late;
        LateDifference difference;
    };
    asio::awaitable<void> judge_late_cases();
    /// By what the master has found itself.
    void judge(const LateCase& late, const Result<ScenarioResult>& right);
    void add_held_trees(WorkerLink& link);
    void end_task_if_complete(TaskId task);
    /// Other workers that have the place of a scenario which this one has answered need not.
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
    /// False: it is not the first of its scenario.
    [[nodiscard]] bool
    merge_one(MasterJob& job, const TakenResult& taken, WorkerId worker, AddResults& add);
    void end_if_complete(MasterJob& job);
    /// The jobs that go on are held back for the workers of before the restart.
    void await_workers();
    asio::awaitable<void> end_waiting(std::shared_ptr<asio::steady_timer> timer);
    /// It has a result: what it was analysed for is of no use any more.
    void close_analysis(MasterJob& job, std::uint64_t scenario);
    void fail_scenario(MasterJob& job, const Scenario& scenario, const std::string& why);

    // Jobs that wait for the disk (coordinator_pauses.cpp).
    /// Why the job waits; empty: it does not.
    void job_paused(MasterJob& job, const std::string& why);
    /// The disk does not take, or give, something of the job: it says so, and no more of it is got
    /// ready to be handed out, until it tries `again` a little later. Whatever else is wrong fails
    /// it.
    void wait_for_disk(MasterJob& job, const Error& why, std::function<void()> again);
    using DiskWaits = std::multimap<JobId, std::shared_ptr<asio::steady_timer>>;
    using DiskWait = DiskWaits::iterator;
    /// The same in a coroutine. Null: the job or the master has ended.
    asio::awaitable<MasterJob*> wait_until_mended(JobId job, Error why);
    asio::awaitable<void> try_again(std::optional<DiskWait> wait, std::function<void()> again);
    /// Nothing: there is nothing to wait for.
    std::optional<DiskWait> begin_to_wait(MasterJob& job, const Error& why);
    asio::awaitable<MasterJob*> end_of_wait(DiskWait wait);
    /// Something of the job could be read.
    void disk_gives(MasterJob& job);
    /// The job ends.
    void stop_waiting(JobId job);
    void add_what_it_waits_for(JobStatus& job) const;

    // Explaining.
    struct EndedScenario;
    [[nodiscard]] asio::awaitable<Result<Explained>> explain_ended(JobId job,
                                                                   std::uint64_t scenario);
    /// What the scenario's result tells, if it has one.
    void add_answer(const MasterJob& job, Explained& explained) const;
    [[nodiscard]] std::string
    answered_by(const MasterJob& job, std::uint64_t scenario, bool needs_worker) const;

    // Results that differ (coordinator_disputes.cpp).
    struct Evidence;
    /// It is judged, by the master's own result, when `add`, which is written next, is on the disk.
    void open_dispute(MasterJob& job, const Dispute& dispute, AddResults& add);
    asio::awaitable<void> settle_dispute(Dispute dispute);
    /// Without evidence the first result stands.
    void settle(MasterJob& job, const Dispute& dispute, std::optional<Evidence> evidence);
    /// What follows from it for the journal goes to `verdict`.
    /// Errors: TooLarge when the right result is.
    [[nodiscard]] Status
    judge(MasterJob& job, const Dispute& dispute, Evidence evidence, AddResults& verdict);
    /// The merged result of the scenario was wrong. `why` the job has no map any more.
    void correct(MasterJob& job,
                 TakenResult right,
                 const ScenarioFacts& wrong,
                 const std::string& why,
                 AddResults& verdict);
    /// What is being computed to settle disputes of the job, or of one of its scenarios, is of no
    /// use any more. False: nothing is.
    bool stop_judging(JobId job, std::optional<std::uint64_t> scenario);
    void alarm(const std::string& text);

    // Who was wrong, and what else may be (coordinator_doubts.cpp).
    void quarantine(WorkerId worker);
    [[nodiscard]] bool is_quarantined(WorkerId worker) const;
    /// Nothing that it says is taken: it is in quarantine, for its own sake or for its holder's.
    [[nodiscard]] bool is_distrusted(WorkerId worker) const;
    /// One whose process was found wrong is not trusted with its next one either.
    [[nodiscard]] bool is_holder_quarantined(const std::string& holder) const;
    void quarantine_holder(WorkerId worker);
    /// For people; also of one that an earlier life of the master knew.
    [[nodiscard]] std::string name_of(WorkerId worker) const;
    /// A number for one of whom only that is known.
    [[nodiscard]] WorkerId earlier_worker(WorkerProcess process);
    /// Goes on with the doubts and disputes of an earlier life.
    void restore_authors(MasterJob& job,
                         std::span<const std::uint64_t> done,
                         std::span<const WorkerProcess> authors,
                         std::span<const Remark> disputes);
    /// The geometry of the job is there.
    void take_up_doubts(MasterJob& job);
    /// What it has answered so far is done again by others.
    void doubt_results_of(WorkerId worker);
    void doubt(MasterJob& job, const std::vector<std::uint64_t>& scenarios);
    /// The geometry of the job is there.
    void answer_again(MasterJob& job, std::span<const std::uint64_t> scenarios);
    void do_again(MasterJob& job, std::vector<std::uint64_t> places);
    /// False: it was not in doubt.
    bool doubt_ends(MasterJob& job, std::uint64_t scenario, WorkerId by);
    /// It was lost with too many workers. To be judged, it would have to run here.
    void give_up_doubt(MasterJob& job, const Scenario& scenario, const std::string& why);
    asio::awaitable<void> fail_doubted(JobId job, Scenario scenario, std::string why);
    /// Of those that are gone: to whom no running job owes a doubt.
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
    /// What of these places has no result, and is in no task, is still to be done.
    void give_again(MasterJob& job, const GivenPlaces& ended, LostWith lost_with);
    /// A scenario that takes down who runs it does not begin anew because the master does.
    void write_losses(MasterJob& job, std::vector<LostPlaces> losses);
    /// Of these places, those whose scenarios have no result.
    [[nodiscard]] static std::vector<PlaceRange> unmerged(const MasterJob& job,
                                                          const GivenPlaces& given);

    /// In seconds, from whatever beginning.
    [[nodiscard]] double now() const;
    // What is durable (coordinator_journal.cpp).
    [[nodiscard]] JournalEvents journal_events();
    std::uint64_t write(JournalEntry entry);
    void journal_committed(std::uint64_t position);
    [[nodiscard]] bool journal_has_room() const;
    void keep_promises();
    void job_ended(JobId job);
    void wake_waiting(JobId job);
    /// Its record goes, and then its files. The job is not on the board any more.
    void drop_from_journal(JobId job);
    /// Now, or when the journal has room.
    void go_on(std::function<void()> done);
    [[nodiscard]] JobStatus status_of(const MasterJob& job) const;

    // What is always true (coordinator_invariants.cpp).
    void check_leases() const;
    void check_job(const MasterJob& job) const;
    /// Scenarios that wait in ranges, or are being done in some.
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
    std::uint64_t epoch_; ///< Of this process.
    WorkerWatch watch_;
    std::map<WorkerId, LostWorker> lost_;             ///< Until they are forgotten.
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
    std::string paused_;        ///< Why the journal does not write; empty: it does.
    std::map<JobId, std::shared_ptr<asio::steady_timer>> waiting_for_acceptance_;
    DiskWaits retries_;                                         ///< Of jobs that wait for the disk.
    using LateKey = std::tuple<JobId, WorkerId, std::uint64_t>; ///< With the message's number.
    std::map<LateKey, LateResults> late_results_;               ///< That cannot be looked at yet.
    std::uint64_t aside_bytes_ = 0;                             ///< Of messages that are set aside.
    std::deque<LateCase> late_cases_;                           ///< The first is being judged.
    std::vector<std::function<void()>> waiting_for_room_;       ///< In the journal.
    AlarmRecord alarms_;
    std::set<WorkerProcess> quarantined_; ///< Those of the alarms, holders among them.
    WorkerSessions sessions_;
    std::map<WorkerProcess, std::weak_ptr<WorkerIntake>> intakes_;
    /// What settles disputes, by scenario, and stops when it is true.
    using Judging =
        std::multimap<std::pair<JobId, std::uint64_t>, std::shared_ptr<std::atomic<bool>>>;
    Judging judging_;
    AwaitedWorkers awaited_;
    std::shared_ptr<asio::steady_timer> awaited_until_; ///< Null: nobody is awaited.
};

} // namespace cd
