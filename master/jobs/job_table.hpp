// Jobs known to the master, from acceptance until their results are dropped.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/job/poses/pose_source.hpp"
#include "master/compute/analyser.hpp"
#include "master/compute/result_check.hpp"
#include "master/dispatch/worker_pace.hpp"
#include "master/geometry/mesh_hold.hpp"
#include "master/jobs/job_retention.hpp"
#include "master/jobs/merged_results.hpp"
#include "master/jobs/place_queue.hpp"
#include "master/journal/job_map.hpp"
#include "master/journal/journal.hpp"
#include "master/journal/ledger.hpp"
#include "master/journal/result_store.hpp"
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

/// Order positions handed out as a range, and their pose window; null for a grid.
struct GivenPlaces {
    PlaceRange places;
    std::shared_ptr<const PoseWindow> window;
};

/// One job. While it runs, `open` holds the analyses for workers whose results are not merged yet.
struct MasterJob {
    MasterJob(JobId job,
              Submit submission,
              std::shared_ptr<ResultStore> store,
              Clock::time_point now)
        : id(job),
          submit(std::move(submission)),
          started(now),
          merged(submit.scenarios),
          results(std::move(store)) {}
    /// Restores a job from before a restart of the master.
    MasterJob(RecoveredJob recovered, Clock::time_point now);

    JobId id;
    Submit submit;           ///< Without its bulk after the end (`drop_bulk`).
    std::uint64_t began = 0; ///< Seconds since 1970.
    Clock::time_point started;
    double seconds_before = 0;              ///< Run time before the last restart of the master.
    JobState state = JobState::Running;     ///< State as shown to clients.
    std::shared_ptr<const MeshHold> meshes; ///< Prevents removal of the meshes.
    MergedResults merged;
    std::shared_ptr<ResultStore> results;
    std::uint64_t changes = 0; ///< Incremented when the status changes, except for its times.

    std::shared_ptr<PoseSource> poses; ///< Set only while the job runs.
    std::string paused;                ///< Disk error that pauses the job; empty if none.

    // The members below are set only while the job runs, once its geometry is loaded.
    std::shared_ptr<const JobMaterial> material;
    TreeId tree_a;
    TreeId tree_b;
    std::unique_ptr<Analyser> analyser; ///< Made when the first analysis begins.
    std::optional<AnalysisInput> analysis_input;
    std::unordered_map<std::uint64_t, std::shared_ptr<const Analysis>> open;
    std::shared_ptr<OrderedPoses> order;
    std::vector<LostPlaces> losses_before; ///< Losses from before a restart, until `todo` is set.
    PlaceQueue todo;
    /// Positions that the dispatcher has but has not sent, by their first position.
    std::map<std::uint64_t, GivenPlaces> given;
    std::uint64_t places_loading = 0; ///< Taken from `todo`, poses still loading.
    LearnedRate analysis_seconds;     ///< Analysis time per scenario.
    LearnedRate matching_seconds;     ///< Time to match and send one analysed scenario.
    LearnedRate work_seconds;         ///< Worker time per scenario.
    /// By index: scenarios with a result, as the analysis skips them. Null: not made yet, or stale.
    std::shared_ptr<const std::vector<bool>> done;
    std::vector<std::uint64_t> cancelled; ///< Scenarios cancelled one by one.
    std::uint64_t disputes = 0;           ///< Number of results to be judged.
    /// Disputes from before a restart, until the geometry to judge them is loaded.
    std::vector<Dispute> disputes_left;

    // Set at the end; clients see it once the journal has committed it.
    std::optional<JobEnd> end;
    Clock::time_point ended;
    std::set<InstanceId> contributors; ///< All authors of its results.

    std::uint64_t answered_by_master = 0;
    std::uint64_t withdrawn = 0; ///< Results of quarantined workers that were withdrawn.
    JobStatistics statistics;
    double compute_seconds = 0;
    JobTraffic traffic;
    HelpAtEnd help;
    std::vector<std::uint32_t> depths; ///< Cut depth of each body; empty before the cut.
    JobMap map;                        ///< Used only if the query asks for maps.

    [[nodiscard]] bool is_running() const { return !end; }
    /// Blocks the analyser has started but not delivered.
    [[nodiscard]] std::uint64_t analyses_under_way() const {
        return analyser == nullptr ? 0 : analyser->under_way();
    }
    /// Removes the leading part of an entry from `given`.
    [[nodiscard]] GivenPlaces take_given(const PlaceRange& places);
    /// Progress record for the journal.
    [[nodiscard]] JobProgress progress(Clock::time_point now) const;
    [[nodiscard]] JobStatus status(Clock::time_point now) const;
};

[[nodiscard]] Error no_job();

/// Jobs by id. Keeps ended jobs and their results as `retention` says, or fewer if they have many
/// results.
class JobTable {
  public:
    explicit JobTable(std::uint64_t results_kept = limits::results_ended_kept_max,
                      JobRetention retention = {})
        : results_kept_(results_kept), retention_(retention) {}

    /// Allocates a job id. It counts as running until the job is added or given up. Errors: Refused
    /// when too many jobs or scenarios are running.
    [[nodiscard]] Result<JobId> next(std::uint64_t scenarios);
    void give_up(JobId job) { begun_.erase(job); }
    /// The job's id must be new.
    MasterJob& add(MasterJob job);
    /// Prevents new jobs from getting ids up to `last`.
    void reserve(JobId last) { last_ = std::max(last_, last.value); }
    /// Null if there is no such job.
    [[nodiscard]] MasterJob* find(JobId job);
    [[nodiscard]] const MasterJob* find(JobId job) const;
    /// The job must exist.
    [[nodiscard]] const MasterJob& at(JobId job) const { return jobs_.at(job); }
    /// Null also if the job has ended.
    [[nodiscard]] MasterJob* find_running(JobId job);

    /// Records the job's end and frees the data only a running job needs. JobState::Done computes
    /// the digest.
    void end(MasterJob& job, JobState state, const std::string& failure, Clock::time_point now);
    /// Makes the end visible to clients. Returns the jobs dropped to make room, oldest end first.
    [[nodiscard]] std::vector<JobId> announce(MasterJob& job);

    /// Forgets jobs whose retention has expired and returns their ids. `now` is in seconds since
    /// 1970.
    [[nodiscard]] std::vector<JobId> drop_expired(std::uint64_t now);
    /// Forgets an ended job.
    void drop(JobId job);

    [[nodiscard]] const std::set<JobId>& running() const { return running_; }
    [[nodiscard]] std::vector<JobStatus> statuses(Clock::time_point now) const;

  private:
    std::map<JobId, MasterJob> jobs_;
    std::set<JobId> running_;
    std::map<JobId, std::uint64_t> begun_; ///< Scenarios of each id allocated but not added.
    std::uint64_t last_ = 0;
    std::uint64_t results_kept_;
    JobRetention retention_;
};

} // namespace cd
