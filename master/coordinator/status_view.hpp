// Builds the status of jobs, workers and alarms that clients see.
#pragma once

#include "common/core/result.hpp"
#include "master/jobs/job_table.hpp"
#include "master/verify/alarms.hpp"
#include "master/workers/worker_directory.hpp"
#include "proto/messages/client_messages.hpp"

#include <string>

namespace cd {

/// A read-only view as of `now`, made for one question.
class StatusView {
  public:
    /// `paused`: reason why the journal cannot write; empty if it can. All references outlive the
    /// view.
    StatusView(const JobTable& jobs,
               const WorkerDirectory& workers,
               const Alarms& alarms,
               const std::string& paused,
               Clock::time_point now)
        : jobs_(jobs), workers_(workers), alarms_(alarms), paused_(paused), now_(now) {}

    /// Status of the job, with the disk error and the long scenarios that it waits for. Errors:
    /// NotFound.
    [[nodiscard]] Result<JobStatus> job(JobId job) const;
    /// Leaves out the master's uptime, its meshes and the sizes of its files.
    [[nodiscard]] ClusterStatus cluster() const;

  private:
    void add_what_it_waits_for(JobStatus& job) const;

    const JobTable& jobs_;
    const WorkerDirectory& workers_;
    const Alarms& alarms_;
    const std::string& paused_;
    Clock::time_point now_;
};

} // namespace cd
