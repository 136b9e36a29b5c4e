// Workers that had work of a job when the master was killed: they bring results of it.
#pragma once

#include "common/core/id.hpp"
#include "master/base/worker_process.hpp"

#include <chrono>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace cd {

/// After a restart of the master: whether somebody may still bring results of a job that goes on.
/// To hand out its scenarios before that would have some of them done twice. A state machine
/// without a clock.
class AwaitedWorkers {
  public:
    using Time = std::chrono::steady_clock::time_point;

    AwaitedWorkers() = default;
    /// Nothing of these jobs is handed out before each of the processes has told all, or `until`.
    AwaitedWorkers(std::set<JobId> jobs, std::set<WorkerProcess> processes, Time until)
        : jobs_(std::move(jobs)), processes_(std::move(processes)), until_(until) {}

    [[nodiscard]] std::size_t size() const { return processes_.size(); }
    /// The process has sent all results that it kept.
    void has_told_all(WorkerProcess process) { processes_.erase(process); }
    /// Results of the job came from an earlier session, and are being checked; then no more.
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
    std::set<WorkerProcess> processes_;
    Time until_{};
    std::map<JobId, std::size_t> checks_; ///< Messages.
};

} // namespace cd
