// The jobs that the master knows, from their acceptance until their results are dropped.
#pragma once

#include "common/core/result.hpp"
#include "common/job/merge.hpp"
#include "common/job/ordered_poses.hpp"
#include "common/job/pose_source.hpp"
#include "master/place_queue.hpp"
#include "master/result_intake.hpp"
#include "master/result_store.hpp"
#include "master/submitter.hpp"
#include "master/worker_pace.hpp"
#include "proto/message.hpp"

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
          accepted(now),
          merger(submit.scenarios),
          results(std::move(store)) {}

    JobId id;
    Submit submit;
    Clock::time_point accepted;
    JobState state = JobState::Running;
    ResultMerger merger;
    std::shared_ptr<ResultStore> results;
    std::uint64_t changes = 0; ///< Grows with whatever a status shows, but time.

    // Only while it runs, and only after its geometry is there.
    std::shared_ptr<const JobMaterial> material;
    TreeId tree_a;
    TreeId tree_b;
    std::unique_ptr<Submitter> submitter;
    std::optional<AnalysisInput> analysis_input; ///< The submitter's.
    std::unordered_map<std::uint64_t, std::shared_ptr<const Analysis>> open;
    std::shared_ptr<OrderedPoses> order;
    PlaceQueue todo;
    /// By first place: what the dispatcher was given and has not sent whole.
    std::map<std::uint64_t, GivenPlaces> given;
    std::uint64_t places_loading = 0; ///< Taken from `todo` to be given.
    LearnedRate analysis_seconds;     ///< Of a scenario,
    LearnedRate matching_seconds;     ///< and what handing it out took after that,
    LearnedRate work_seconds;         ///< and a worker's.

    // Once it has ended.
    Clock::time_point ended;
    std::string failure;
    std::optional<Sha256> digest;

    std::uint64_t answered_by_master = 0;
    JobStatistics statistics;
    double compute_seconds = 0;

    [[nodiscard]] bool is_running() const { return state == JobState::Running; }
    [[nodiscard]] JobStatus status(Clock::time_point now) const;
};

/// Jobs by id. Those that have ended are kept with their results, the last
/// `limits::jobs_ended_kept_max` of them.
class JobBoard {
  public:
    /// Errors: Refused with too many jobs running.
    [[nodiscard]] Result<MasterJob*>
    add(Submit submit, std::shared_ptr<ResultStore> results, Clock::time_point now);
    /// Null where there is none.
    [[nodiscard]] MasterJob* find(JobId job);
    /// The job is here.
    [[nodiscard]] const MasterJob& at(JobId job) const { return jobs_.at(job); }
    /// Null also when it has ended.
    [[nodiscard]] MasterJob* find_running(JobId job);

    /// Writes down how it ended and frees what only a running job needs.
    void end(MasterJob& job, JobState state, const std::string& failure, Clock::time_point now);

    /// Those that run.
    [[nodiscard]] const std::set<JobId>& running() const { return running_; }
    [[nodiscard]] std::vector<JobStatus> statuses(Clock::time_point now) const;

  private:
    void drop_oldest_ended();

    std::map<JobId, MasterJob> jobs_;
    std::set<JobId> running_;
    std::uint64_t last_ = 0;
};

} // namespace cd
