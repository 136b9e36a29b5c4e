// Workers that had work of a job when the master was killed, and may still deliver its results.
#pragma once

#include "common/core/id.hpp"
#include "master/base/instance_id.hpp"

#include <chrono>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace cd {

/// After a restart of the master, holds back resumed jobs while workers may still deliver their
/// results. Handing out scenarios earlier would repeat some of them. A state machine without a
/// clock.
class AwaitedWorkers {
  public:
    using Time = std::chrono::steady_clock::time_point;

    AwaitedWorkers() = default;
    /// Holds `jobs` back until each process has delivered everything, or until the time `until`.
    AwaitedWorkers(std::set<JobId> jobs, std::set<InstanceId> processes, Time until)
        : jobs_(std::move(jobs)), processes_(std::move(processes)), until_(until) {}

    [[nodiscard]] std::size_t size() const { return processes_.size(); }
    /// The process has sent all results that it kept.
    void has_told_all(InstanceId process) { processes_.erase(process); }
    /// Counts the job's results from earlier sessions that are being checked.
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
    std::map<JobId, std::size_t> checks_; ///< Number of messages being checked.
};

} // namespace cd
