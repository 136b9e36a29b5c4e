// The jobs that the master knows, from their acceptance until their results are dropped.
#pragma once

#include "common/core/limits_master.hpp"
#include "common/core/result.hpp"
#include "common/job/merge.hpp"
#include "common/job/ordered_poses.hpp"
#include "common/job/pose_source.hpp"
#include "master/job_map.hpp"
#include "master/job_retention.hpp"
#include "master/journal.hpp"
#include "master/ledger.hpp"
#include "master/mesh_hold.hpp"
#include "master/place_queue.hpp"
#include "master/result_intake.hpp"
#include "master/result_store.hpp"
#include "master/submitter.hpp"
#include "master/worker_pace.hpp"
#include "proto/client_messages.hpp"
#include "proto/traffic.hpp"
#include "proto/work_messages.hpp"

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
    /// One that an earlier life of the master has left.
    MasterJob(RecoveredJob recovered, Clock::time_point now);

    JobId id;
    Submit submit;           ///< Once it has ended, without its bulk (`drop_bulk`).
    std::uint64_t began = 0; ///< In seconds since 1970.
    Clock::time_point started;
    double seconds_before = 0;              ///< In earlier lives of the master.
    JobState state = JobState::Running;     ///< As clients are told.
    std::shared_ptr<const MeshHold> meshes; ///< Its own, as long as it is known.
    ResultMerger merger;
    std::shared_ptr<ResultStore> results;
    std::uint64_t changes = 0; ///< Grows with whatever a status shows, but time.

    std::shared_ptr<PoseSource> poses; ///< Only while it runs: all of them.
    std::string paused;                ///< What it waits for, of the disk; empty: nothing.

    // Only while it runs, and only after its geometry is there.
    std::shared_ptr<const JobMaterial> material;
    TreeId tree_a;
    TreeId tree_b;
    std::unique_ptr<Submitter> submitter;
    std::optional<AnalysisInput> analysis_input; ///< The submitter's.
    std::unordered_map<std::uint64_t, std::shared_ptr<const Analysis>> open;
    std::shared_ptr<OrderedPoses> order;
    std::vector<LostPlaces> losses_before; ///< In an earlier life of the master, until `todo` is.
    PlaceQueue todo;
    /// By first place: what the dispatcher was given and has not sent.
    std::map<std::uint64_t, GivenPlaces> given;
    std::uint64_t places_loading = 0; ///< Taken from `todo` to be given.
    LearnedRate analysis_seconds;     ///< Of a scenario,
    LearnedRate matching_seconds;     ///< and what handing it out took after that,
    LearnedRate work_seconds;         ///< and a worker's.
    /// Whose result of a scenario was merged, up to the last that came; 0 is the master, or nobody
    /// knows any more. Of a job that has ended, those of its first scenarios.
    std::vector<std::uint32_t> authors;
    /// All authors of its results, kept when it has ended.
    std::set<WorkerProcess> contributors;
    /// Merged results of a worker that was found to be wrong: they are done again, and compared.
    std::set<std::uint64_t> doubted;
    /// Of those that were in doubt: they were lost with too many workers, and fail.
    std::set<std::uint64_t> given_up;
    std::vector<std::uint64_t> cancelled; ///< Scenarios, one by one.
    std::uint64_t disputes = 0;           ///< Results that are to be judged.
    /// Of these, those from an earlier life, until the geometry to judge them is there.
    std::vector<Dispute> disputes_left;

    // Once it has ended. Clients are told when that is in the journal.
    std::optional<JobEnd> end;
    Clock::time_point ended;
    bool has_dropped_bulk = false;  ///< Its scenarios cannot be run any more.
    bool is_to_be_repeated = false; ///< An alarm has said so.

    std::uint64_t answered_by_master = 0;
    JobStatistics statistics;
    double compute_seconds = 0;
    JobTraffic traffic;
    HelpAtEnd help;
    std::vector<std::uint32_t> depths; ///< By body, where its tree is cut, once it is.
    JobMap map;                        ///< Where the query is for maps.

    [[nodiscard]] bool is_running() const { return !end; }
    /// The scenario has no result, or one that is in doubt.
    [[nodiscard]] bool lacks(std::uint64_t scenario) const {
        return !merger.has(scenario) || doubted.contains(scenario);
    }
    /// What is first of something in `given`; it is no longer there.
    [[nodiscard]] GivenPlaces take_given(const PlaceRange& places);
    /// For the journal.
    [[nodiscard]] JobProgress progress(Clock::time_point now) const;
    [[nodiscard]] JobStatus status(Clock::time_point now) const;
};

[[nodiscard]] Error no_job();

/// Jobs by id. Those that have ended are kept with their results as `retention` says, or fewer with
/// many results.
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

    /// Forgets jobs that are kept no longer. `now` is in seconds since 1970. Their ids.
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
