// The jobs that the master knows, from their acceptance until their results are dropped.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/result/merge.hpp"
#include "master/dispatch/worker_pace.hpp"
#include "master/geometry/mesh_hold.hpp"
#include "master/jobs/job_retention.hpp"
#include "master/jobs/place_queue.hpp"
#include "master/jobs/submitter.hpp"
#include "master/journal/job_map.hpp"
#include "master/journal/journal.hpp"
#include "master/journal/ledger.hpp"
#include "master/journal/result_store.hpp"
#include "master/results/result_intake.hpp"
#include "proto/messages/client_messages.hpp"
#include "proto/messages/traffic.hpp"
#include "proto/messages/work_messages.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace cd {

using Clock = std::chrono::steady_clock;

/// Places that go out in ranges, and their window; null for a grid.
struct GivenPlaces {
    PlaceRange places;
    std::shared_ptr<const PoseWindow> window;
};

/// One job. While it runs, `open` holds what was analysed for the workers and is not merged yet.
struct MasterJob {
    MasterJob(JobId job,
              Submit submission,
              std::shared_ptr<ResultStore> store,
              Clock::time_point now)
        : id(job),
          submit(std::move(submission)),
          started(now),
          merger(submit.scenarios),
          results(std::move(store)) {}
    /// A job from before a restart of the master.
    MasterJob(RecoveredJob recovered, Clock::time_point now);

    JobId id;
    Submit submit;           ///< Without its bulk once it has ended (`drop_bulk`).
    std::uint64_t began = 0; ///< In seconds since 1970.
    Clock::time_point started;
    double seconds_before = 0;              ///< Before the last restart of the master.
    JobState state = JobState::Running;     ///< As shown to clients.
    std::shared_ptr<const MeshHold> meshes; ///< Keeps them from being removed.
    ResultMerger merger;
    std::shared_ptr<ResultStore> results;
    std::uint64_t changes = 0; ///< Grows when the status changes, except for its times.

    std::shared_ptr<PoseSource> poses; ///< Set only while the job runs.
    std::string paused;                ///< The error of the disk that it waits for; or empty.

    // Only while it runs, and only after its geometry is there.
    std::shared_ptr<const JobMaterial> material;
    TreeId tree_a;
    TreeId tree_b;
    std::unique_ptr<Submitter> submitter; ///< Made when the first analysis begins.
    std::optional<AnalysisInput> analysis_input;
    std::unordered_map<std::uint64_t, std::shared_ptr<const Analysis>> open;
    std::shared_ptr<OrderedPoses> order;
    std::vector<LostPlaces> losses_before; ///< From before a restart, until `todo` is set.
    PlaceQueue todo;
    /// Places that the dispatcher has been given and has not sent, by their first place.
    std::map<std::uint64_t, GivenPlaces> given;
    std::uint64_t places_loading = 0; ///< Taken from `todo` to be given.
    LearnedRate analysis_seconds;     ///< Analysing one scenario.
    LearnedRate matching_seconds;     ///< Matching and sending one analysed scenario.
    LearnedRate work_seconds;         ///< A worker's time for one scenario.
    /// The worker whose result was merged, by scenario; 0 for the master or an unknown one. A job
    /// that has ended keeps at most `limits::authors_kept_max`.
    std::vector<std::uint32_t> authors;
    /// All authors of its results, kept when it has ended.
    std::set<WorkerProcess> contributors;
    /// Scenarios with a merged result of a worker that was wrong elsewhere: they are repeated and
    /// compared.
    std::set<std::uint64_t> doubted;
    /// Scenarios in doubt that were lost with too many workers, and fail.
    std::set<std::uint64_t> given_up;
    std::vector<std::uint64_t> cancelled; ///< Scenarios that were cancelled singly.
    std::uint64_t disputes = 0;           ///< Results that are to be judged.
    /// Disputes from before a restart, until the geometry to judge them is there.
    std::vector<Dispute> disputes_left;

    // Set when the job has ended. Clients see it once the journal has it.
    std::optional<JobEnd> end;
    Clock::time_point ended;
    bool has_dropped_bulk = false;  ///< Its scenarios cannot be run any more.
    bool is_to_be_repeated = false; ///< An alarm has said so.

    std::uint64_t answered_by_master = 0;
    JobStatistics statistics;
    double compute_seconds = 0;
    JobTraffic traffic;
    HelpAtEnd help;
    std::vector<std::uint32_t> depths; ///< Of each body's cut; empty before that.
    JobMap map;                        ///< Used if the query asks for maps.

    [[nodiscard]] bool is_running() const { return !end; }
    /// The scenario has no result, or one that is in doubt.
    [[nodiscard]] bool lacks(std::uint64_t scenario) const {
        return !merger.has(scenario) || doubted.contains(scenario);
    }
    /// Blocks that the submitter has started and not yet delivered.
    [[nodiscard]] std::uint64_t analyses_under_way() const {
        return submitter == nullptr ? 0 : submitter->under_way();
    }
    /// Takes the first part of an entry out of `given`.
    [[nodiscard]] GivenPlaces take_given(const PlaceRange& places);
    /// For the journal.
    [[nodiscard]] JobProgress progress(Clock::time_point now) const;
    [[nodiscard]] JobStatus status(Clock::time_point now) const;
};

[[nodiscard]] Error no_job();

/// Jobs by id. Keeps those that have ended, with their results, as `retention` says, or fewer of
/// them if they have many results.
class JobBoard {
  public:
    explicit JobBoard(std::uint64_t results_kept = limits::results_ended_kept_max,
                      JobRetention retention = {})
        : results_kept_(results_kept), retention_(retention) {}

    /// The number of a new job, which counts among those that run until it is added or given up.
    /// Errors: Refused with too many jobs, or scenarios, running.
    [[nodiscard]] Result<JobId> next(std::uint64_t scenarios);
    void give_up(JobId job) { begun_.erase(job); }
    /// The number is new.
    MasterJob& add(MasterJob job);
    /// No job gets this number, or a lesser one, any more.
    void reserve(JobId last) { last_ = std::max(last_, last.value); }
    /// Null where there is none.
    [[nodiscard]] MasterJob* find(JobId job);
    /// The job is here.
    [[nodiscard]] const MasterJob& at(JobId job) const { return jobs_.at(job); }
    /// Null also when it has ended.
    [[nodiscard]] MasterJob* find_running(JobId job);

    /// Writes down how it ended and frees what only a running job needs. Done takes a digest.
    void end(MasterJob& job, JobState state, const std::string& failure, Clock::time_point now);
    /// From now on clients see that it has ended. The jobs that are dropped for it, those first
    /// that ended first.
    [[nodiscard]] std::vector<JobId> announce(MasterJob& job);

    /// Forgets the jobs whose retention is over and returns their ids. `now` is in seconds since
    /// 1970.
    [[nodiscard]] std::vector<JobId> drop_expired(std::uint64_t now);
    /// Forgets a job that has ended.
    void drop(JobId job);

    /// Those that run.
    [[nodiscard]] const std::set<JobId>& running() const { return running_; }
    [[nodiscard]] std::vector<JobStatus> statuses(Clock::time_point now) const;

  private:
    std::map<JobId, MasterJob> jobs_;
    std::set<JobId> running_;
    std::map<JobId, std::uint64_t> begun_; ///< Their scenarios.
    std::uint64_t last_ = 0;
    std::uint64_t results_kept_;
    JobRetention retention_;
};

} // namespace cd
