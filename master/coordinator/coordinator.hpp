// Connects worker sessions and jobs to the dispatcher: feeds it events and performs its actions.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/core/limits/master.hpp"
#include "master/base/disk_retries.hpp"
#include "master/blocks/block_delivery.hpp"
#include "master/compute/reference_run.hpp"
#include "master/coordinator/explainer.hpp"
#include "master/coordinator/status_view.hpp"
#include "master/dispatch/dispatcher.hpp"
#include "master/geometry/geometry_store.hpp"
#include "master/geometry/tree_registry.hpp"
#include "master/jobs/job_table.hpp"
#include "master/jobs/job_waits.hpp"
#include "master/journal/journal_writer.hpp"
#include "master/verify/alarms.hpp"
#include "master/workers/awaited_workers.hpp"
#include "master/workers/worker_directory.hpp"
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

/// References to the services that the coordinator uses; all of them outlive it.
struct CoordinatorParts {
    asio::any_io_executor executor; ///< Runs on one thread, which owns all state.
    GeometryStore& geometry;
    ThreadPool& compute;  ///< Runs analyses and checks results.
    ThreadPool& blocking; ///< Runs tasks that block on the disk or on `compute`.
    /// Not started yet. Must stop before the executor's context, and after the coordinator.
    Journal& journal;
    std::filesystem::path directory; ///< Spool directory for incoming poses.
    Durability durability = Durability::Synced;
    FailureTimes times;
    std::uint64_t results_aside_bytes_max = limits::results_aside_bytes_max;
    JobRetention retention = {};
};

/// Owns all jobs and workers. All members run on the executor's thread.
class Coordinator : private WorkerEvents {
  public:
    /// Call `restore` before anything else.
    explicit Coordinator(CoordinatorParts parts);
    Coordinator(const Coordinator&) = delete;
    Coordinator& operator=(const Coordinator&) = delete;
    ~Coordinator() override;

    /// Resumes the jobs in the journal and starts the journal. Blocks on the disk. Errors: Io,
    /// naming a damaged pose file.
    [[nodiscard]] Status restore(Recovered recovered);
    [[nodiscard]] const Sha256& cluster() const { return cluster_; }

    [[nodiscard]] const asio::any_io_executor& executor() const { return parts_.executor; }
    [[nodiscard]] GeometryStore& geometry() { return parts_.geometry; }
    [[nodiscard]] ThreadPool& blocking() { return parts_.blocking; }
    [[nodiscard]] const Journal& journal() const { return parts_.journal; }
    [[nodiscard]] const std::filesystem::path& directory() const { return parts_.directory; }

    // ---- Workers (coordinator_workers.cpp) ------------------------------------------------------
    [[nodiscard]] const FailureTimes& times() const { return parts_.times; }
    [[nodiscard]] WorkerDirectory& workers() { return workers_; }
    void worker_stands(WorkerId worker, const Standing& standing);
    /// Stops all timers; the master is shutting down.
    void close();
    void evicted(WorkerId worker, const Evicted& evicted);
    void cuts_held(WorkerId worker, const Holding& holding);
    void blocks_wanted(WorkerId worker, const WantSubtrees& want);
    void blocks_held(WorkerId worker, const Held& held);
    void peer_failed(WorkerId worker, const FetchFailed& failed);
    /// Checks the results on the pool, merges them, and calls `done` when the journal has room.
    /// Acknowledges them once they are durable. Invalid results cut the worker off.
    void results_came(WorkerId worker, Results results, std::function<void()> done);
    void task_ended(WorkerId worker, TaskId task);
    void task_recalled(WorkerId worker, const Recalled& recalled);
    /// Gives the worker no new work; it leaves when its current work is finished.
    void worker_draining(WorkerId worker);
    /// Asks a connected worker to hand over its work and leave.
    void drain_worker(WorkerId worker);
    /// Orders a connected worker to exit at once. Its work returns to the queue and is not counted
    /// as lost.
    void terminate_worker(WorkerId worker);

    // ---- Jobs (coordinator_jobs.cpp) ------------------------------------------------------------
    [[nodiscard]] Durability durability() const { return parts_.durability; }
    /// Coroutines that wait for the acceptance, the end or the removal of a job.
    [[nodiscard]] JobWaits& waits() { return waits_; }
    /// Explains scenarios as of now.
    [[nodiscard]] Explainer explainer();
    /// Allots the id of a new job, which is then begun or given up. Errors: Refused; Io when the
    /// journal does not write.
    [[nodiscard]] Result<JobId> allot_job(std::uint64_t scenarios);
    void give_up_job(JobId job) { jobs_.give_up(job); }
    /// Writes an allotted job to the journal and wakes those who wait for it when that is durable.
    void write_job(const JobRecord& job) { writer_.write(AcceptJob{job}); }
    /// Begins a job that the journal has committed.
    void begin_job(const JobRecord& record,
                   std::shared_ptr<ResultStore> results,
                   std::shared_ptr<PoseSource> poses);
    /// Ends a running job and wakes those who wait for it when that is durable. Does nothing if the
    /// job has ended. Errors: NotFound.
    [[nodiscard]] Result<JobStatus> cancel_job(JobId job);
    /// Forgets an ended job and wakes those who wait for it when the journal has deleted it; its
    /// files are removed next. Errors: NotFound; Refused while it runs; Io when the journal does
    /// not write.
    [[nodiscard]] Status forget_job(JobId job);
    /// Forgets jobs whose retention has expired. `now` is in seconds since 1970.
    void forget_expired_jobs(std::uint64_t now);
    /// Stops the master's run of a scenario in dispute, which then counts as failed. False: there
    /// is none.
    [[nodiscard]] bool cancel_disputed(JobId job, std::uint64_t scenario);
    /// The poses of a running job whose scenario has no result. Errors: NotFound; Refused.
    [[nodiscard]] Result<std::shared_ptr<PoseSource>> poses_of_unanswered(JobId job,
                                                                          std::uint64_t scenario);
    /// Fails the scenario and stops it on all workers; the job continues. Errors: NotFound; Refused
    /// if the scenario has a result.
    [[nodiscard]] Status cancel_scenario(JobId job, const Scenario& scenario);
    /// Errors: NotFound.
    [[nodiscard]] Result<JobStatus> job_status(JobId job) const { return status().job(job); }
    [[nodiscard]] const JobTable& jobs() const { return jobs_; }
    /// Errors: NotFound; Refused unless the job is done.
    [[nodiscard]] Result<ContactMapAnswer> contact_map(JobId job);
    [[nodiscard]] ClusterStatus cluster_status() const;
    /// Reason why the master cannot accept or acknowledge now; empty if it can.
    [[nodiscard]] const std::string& paused() const { return writer_.paused(); }

    /// Alarms and quarantined processes of all incarnations of the master.
    [[nodiscard]] const Alarms& alarms() const { return alarms_; }

    /// Aborts if an invariant is broken. For tests; call it between two events.
    void check_invariants() const;
    /// Blocks that other workers may fetch from this worker. Empty if it is disconnected or has not
    /// sent its Standing. For tests; call it between two events.
    [[nodiscard]] std::set<BlockKey> blocks_held_by(WorkerId worker) const;

  private:
    struct RunningTask {
        WorkerId worker;
        std::shared_ptr<const TaskContent> content;
        std::size_t in_hand = 0;    ///< Result messages being checked.
        bool ended = false;         ///< The worker has sent all its results.
        bool unbegun = false;       ///< The task never reached the worker.
        bool is_called_off = false; ///< Ranges only: some answers are no longer owed.
        bool is_copy = false;       ///< Speculative copy: another worker has this work too.
        std::optional<PlaceRange> places = {}; ///< Ranges only: the positions not returned.
    };
    /// Results that belong to no current task: their session or their job has ended.
    struct LateResults {
        std::shared_ptr<const Author> author;
        std::shared_ptr<const Results> message;
        std::function<void()> done;
    };
    /// Checked results on their way into the job.
    struct ResultsInHand {
        std::shared_ptr<const Author> author;
        std::shared_ptr<const TaskContent> task; ///< Null for late results.
        std::shared_ptr<const Results> message;
        Result<TakenResults> taken;
        std::function<void()> done;
        std::vector<std::uint64_t> mapped; ///< Covered by the recomputed map; else empty.

        [[nodiscard]] JobId job() const { return task == nullptr ? message->job : task->job; }
    };

    // Workers.
    void worker_joined(WorkerId worker, const Hello& hello) override;
    void worker_replaced(WorkerId worker) override { take_all_back(worker); }
    void worker_resumed(WorkerId worker) override;
    void worker_detached(WorkerId worker) override;
    void worker_silent(WorkerId worker) override;
    void worker_heard_again(WorkerId worker) override;
    /// Requeues the worker's work.
    void worker_left(WorkerId worker) override;
    [[nodiscard]] WorkerStatus work_of(WorkerId worker) const override;
    /// Returns the unanswered work of its tasks to the queue, not counted as lost, and gives the
    /// worker no more work.
    void take_all_back(WorkerId worker);
    [[nodiscard]] Status check_standing(const Standing& standing) const;
    asio::awaitable<void> watch_workers();
    void take_lost_blocks(WorkerId worker, const Standing& standing);
    void take_lost_tasks(WorkerId worker, const Standing& standing);
    void forget_tasks(WorkerId worker);
    /// Merges checked results and promises their acknowledgement.
    void results_taken(const ResultsInHand& hand, Result<TakenResults> taken);
    void take_in(std::shared_ptr<ResultsInHand> hand);
    /// Returns the scenarios of `results` that are not merged.
    [[nodiscard]] static std::vector<std::uint64_t>
    new_scenarios(const MasterJob& job, std::span<const TakenResult> results);
    /// Recomputes the contact map for `hand->mapped` only, then resumes ingestion.
    void make_map(const MasterJob& job, std::shared_ptr<ResultsInHand> hand);
    void map_made(const std::shared_ptr<ResultsInHand>& hand, Result<ContactMap> map);
    void withdraw_map(MasterJob& job, const std::string& why);
    /// True if this sequence number was received before; such a message's times are not measured.
    [[nodiscard]] bool is_repeated(WorkerId worker, std::uint64_t sequence);

    // Late results, which belong to no task (coordinator_late.cpp).
    /// Parks results that wait for the disk or for their job. The worker continues while parking
    /// space is left; otherwise the master stops reading from it. `take_up` releases them.
    void set_aside(const Results& message, std::function<void()>& done);
    void take_up(const Results& message);
    void late_results_came(LateResults late);
    void put_away(LateResults late);
    void forget_late_results(WorkerId worker);
    [[nodiscard]] bool has_late_results(JobId job) const;
    /// Resumes late results that waited for the job's geometry, or for a disk until its end.
    void look_at_late_results(JobId job);
    void check_late_results(const MasterJob& job, LateResults late);
    void late_results_checked(std::shared_ptr<ResultsInHand> hand);
    void end_task_if_complete(TaskId task);
    /// Cancels speculative copies of `scenario` on all workers except `worker`.
    void call_off_places(const MasterJob& job, WorkerId worker, std::uint64_t scenario);
    void add_job_to(Worker& worker, const MasterJob& job);
    static void drop_cancelled(const Worker& worker, const MasterJob& job);
    void note_work(WorkerId worker);

    // Jobs.
    /// Makes the job's geometry on the pool.
    void prepare_job(const MasterJob& job);
    void job_prepared(JobId job, const StoreResult<JobGeometry>& made);
    void start_job(MasterJob& job, const JobGeometry& made);
    /// Makes the job's analyser. It skips scenarios that already have a result, for example those
    /// that workers delivered again after a restart.
    void begin_analysis(MasterJob& job);
    void block_came(JobId job, AnalysedBlock block, std::vector<TakenResult> finished);
    /// The only path by which results enter a job and the journal. `author` is null for the master.
    void merge(MasterJob& job, TakenResults taken, const std::shared_ptr<const Author>& author);
    /// Moves the record of `taken`. Returns the dispute if the scenario has another result.
    [[nodiscard]] std::optional<Dispute> merge_one(MasterJob& job,
                                                   TakenResult& taken,
                                                   const std::shared_ptr<const Author>& author,
                                                   AddResults& add);
    void end_if_complete(MasterJob& job);
    /// Holds back resumed jobs until the workers from before the restart have returned.
    void await_workers();
    asio::awaitable<void> end_waiting(std::shared_ptr<asio::steady_timer> timer);
    /// Frees the analysis of a scenario that has a result.
    void close_analysis(MasterJob& job, std::uint64_t scenario);
    void fail_scenario(MasterJob& job, const Scenario& scenario, const std::string& why);

    // Jobs that wait for the disk (coordinator_pauses.cpp).
    /// Sets the job's pause reason; an empty one resumes it.
    void job_paused(MasterJob& job, const std::string& why);
    /// Pauses the job after a disk error and calls `again` a little later. A paused job prepares no
    /// more work. Any other error fails the job. `again` gets null if the job has ended.
    void wait_for_disk(MasterJob& job, const Error& why, std::function<void(MasterJob*)> again);
    /// Reports that the disk works again for the job.
    void disk_gives(MasterJob& job);

    // Disputes (coordinator_disputes.cpp).
    /// Records the dispute in `add`. Once that is durable, the master's own result decides it.
    [[nodiscard]] Dispute open_dispute(MasterJob& job, Dispute dispute, AddResults& add);
    void run_disputed(const Dispute& dispute);
    void settle(MasterJob& job, const Dispute& dispute, ReferenceResult right);
    /// Gives the process no more work and withdraws its results from all running jobs.
    void quarantine(const Author& wrong);
    void withdraw_results_of(const Author& wrong);
    void withdraw_results_of(const Author& wrong, MasterJob& job);
    /// Queues scenarios whose results were withdrawn. Requires the job's geometry.
    void hand_out_again(MasterJob& job, std::span<const std::uint64_t> scenarios);
    void put_back_places(MasterJob& job, std::vector<std::uint64_t> places);

    void end_job(MasterJob& job, JobState state, const std::string& failure);
    void release_tree(TreeId tree);

    // Choosing the work to hand out next (coordinator_feed.cpp).
    /// Requests more analyses and queues order positions where there is room. Tells the dispatcher
    /// when no more work follows.
    void feed();
    [[nodiscard]] bool has_room_for_analysis(std::uint64_t under_way) const;
    [[nodiscard]] bool prefers_ranges_now(const MasterJob& job) const;
    /// Gives the job's next order positions to the dispatcher until it has enough.
    void give_places(MasterJob& job);
    void places_came(JobId job,
                     const PlaceRange& places,
                     const Result<std::shared_ptr<const PoseWindow>>& window);
    void give_unmerged(MasterJob& job, const GivenPlaces& given);
    void take_places_back(MasterJob& job);
    /// Requeues those positions that have no result and are in no task.
    void give_again(MasterJob& job, const GivenPlaces& ended, LostWith lost_with);
    /// Journals the losses of scenarios, so that a restart does not retry a worker-killing scenario
    /// from zero.
    void write_losses(MasterJob& job, std::vector<LostPlaces> losses);
    /// Returns the positions whose scenarios have no result.
    [[nodiscard]] static std::vector<PlaceRange> unmerged(const MasterJob& job,
                                                          const GivenPlaces& given);

    [[nodiscard]] StatusView status() const;
    /// Seconds since a fixed point in time.
    [[nodiscard]] double now() const;
    // Reactions to commits of the journal (coordinator_journal.cpp).
    [[nodiscard]] JournalWriter::Events journal_events();
    void job_ended(JobId job);
    /// Deletes the files of a job that the journal has forgotten.
    void job_dropped(JobId job);
    /// Deletes the record and then the files of a job that has left the board.
    void drop_from_journal(JobId job);

    // Invariants (coordinator_invariants.cpp).
    void check_leases() const;
    void check_job(const MasterJob& job) const;
    /// Marks the scenarios that wait or run in ranges.
    [[nodiscard]] std::vector<bool> scenarios_in_ranges(const MasterJob& job) const;

    /// Returns the dispatcher after setting its clock.
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
    WorkerDirectory workers_;
    std::shared_ptr<asio::steady_timer> watch_timer_; ///< Null while no worker is watched.
    bool closed_ = false;
    /// Copy of `closed_` for other threads.
    std::shared_ptr<std::atomic<bool>> closing_ = std::make_shared<std::atomic<bool>>(false);
    std::map<TaskId, RunningTask> tasks_;
    TreeRegistry trees_;
    BlockDelivery blocks_;
    JobTable jobs_;
    JobId fed_last_;
    std::uint64_t open_bytes_ = 0; ///< Bytes of all jobs' open analyses.
    JobWaits waits_{parts_.executor};
    JournalWriter writer_;
    Sha256 cluster_;
    DiskRetries retries_; ///< Steps of jobs paused by the disk.
    using LateKey = std::tuple<JobId, WorkerId, std::uint64_t>; ///< And sequence number.
    std::map<LateKey, LateResults> late_results_;               ///< Late results not examined yet.
    std::uint64_t aside_bytes_ = 0;                             ///< Bytes of all parked results.
    Alarms alarms_;
    ReferenceRuns references_; ///< Runs that settle disputes.
    AwaitedWorkers awaited_;
    std::shared_ptr<asio::steady_timer> awaited_until_; ///< Null if no worker is awaited.
};

} // namespace cd
