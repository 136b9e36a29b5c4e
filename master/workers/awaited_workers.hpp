// Worker processes that may still have results from before a restart of the master.
#pragma once

#include "common/core/id.hpp"
#include "master/base/instance_id.hpp"

#include <chrono>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace cd {

/// After a restart of the master, holds back resumed jobs while workers may still deliver results
/// of them. Otherwise the master would hand out scenarios that have a result. A state machine
/// without a clock.
class AwaitedWorkers {
  public:
    using Time = std::chrono::steady_clock::time_point;

    AwaitedWorkers() = default;
    /// Holds `jobs` back until all processes have delivered their results, but at most until the
    /// time `until`.
    AwaitedWorkers(std::set<JobId> jobs, std::set<InstanceId> processes, Time until)
        : jobs_(std::move(jobs)), processes_(std::move(processes)), until_(until) {}

    [[nodiscard]] std::size_t size() const { return processes_.size(); }
    /// The process has delivered all results that it had kept.
    void has_told_all(InstanceId process) { processes_.erase(process); }
    /// Call before and after the check of a late result message of the job.
    void check_begins(JobId job) { ++checks_[job]; }
    void check_ends(JobId job) {
        if (--checks_.at(job) == 0) {
            checks_.erase(job);
        }
    }

    [[nodiscard]] bool holds_back(JobId job, Time now) const {
        return now < until_ && jobs_.contains(job) &&
               (!processes_.empty() || checks_.contains(job));
    }

  private:
    std::set<JobId> jobs_;
    std::set<InstanceId> processes_;
    Time until_{};
    std::map<JobId, std::size_t> checks_; ///< Number of late result messages being checked.
};

} // namespace cd
