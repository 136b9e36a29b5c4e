// The jobs that the master knows, from acceptance until their results are dropped.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "master/jobs/job.hpp"
#include "master/jobs/job_retention.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cd {

[[nodiscard]] Error no_job();

/// Holds the jobs by id, and the clock for their times. Keeps ended jobs as long as `retention`
/// allows, but drops the oldest when ended jobs have more than `results_kept` results together.
class JobTable {
  public:
    explicit JobTable(std::uint64_t results_kept = limits::results_ended_kept_max,
                      JobRetention retention = {},
                      std::function<Clock::time_point()> now = Clock::now)
        : results_kept_(results_kept), retention_(retention), now_(std::move(now)) {}

    [[nodiscard]] Clock::time_point now() const { return now_(); }

    /// Allocates a job id. Until `add` or `give_up` is called, the id counts as a running job of
    /// `scenarios` scenarios. Errors: Refused when too many jobs or scenarios are running.
    [[nodiscard]] Result<JobId> next(std::uint64_t scenarios);
    /// Frees an id from `next`, because its job does not start.
    void give_up(JobId job) { begun_.erase(job); }
    /// Adds a job, whose id must be new.
    MasterJob& add(MasterJob job);
    /// Prevents new jobs from getting ids up to `last`.
    void reserve(JobId last) { last_ = std::max(last_, last.value); }
    /// Null if there is no such job.
    [[nodiscard]] MasterJob* find(JobId job);
    [[nodiscard]] const MasterJob* find(JobId job) const;
    /// The job must exist.
    [[nodiscard]] const MasterJob& at(JobId job) const { return jobs_.at(job); }
    [[nodiscard]] MasterJob& at(JobId job) { return jobs_.at(job); }
    [[nodiscard]] const std::map<JobId, MasterJob>& all() const { return jobs_; }
    /// Null if there is no such job, or it has ended.
    [[nodiscard]] MasterJob* find_running(JobId job);

    /// Records the job's end (`MasterJob::finish`).
    void end(MasterJob& job, JobState state, const std::string& failure, Clock::time_point now);
    /// Shows the job's end to clients. Drops jobs to make room, and returns them, oldest end first.
    [[nodiscard]] std::vector<JobId> announce(MasterJob& job);

    /// Forgets jobs whose retention has expired and returns their ids. `now` is in seconds since
    /// 1970.
    [[nodiscard]] std::vector<JobId> drop_expired(std::uint64_t now);
    /// Forgets a job, which must have ended.
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
    std::function<Clock::time_point()> now_;
};

} // namespace cd
