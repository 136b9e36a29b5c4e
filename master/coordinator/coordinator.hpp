// The centre of the master: connects its parts, and routes events between them.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "master/coordinator/job_desk.hpp"
#include "master/coordinator/master_services.hpp"
#include "master/coordinator/master_state.hpp"
#include "master/coordinator/worker_desk.hpp"

namespace cd {

/// Owns all jobs and workers. All members run on the executor's thread.
class Coordinator {
  public:
    /// Call `restore` before any other member.
    explicit Coordinator(CoordinatorParts parts);
    Coordinator(const Coordinator&) = delete;
    Coordinator& operator=(const Coordinator&) = delete;

    /// Resumes the jobs found in the journal and starts its writer. Blocks on the disk. Errors: Io,
    /// naming a damaged pose file.
    [[nodiscard]] Status restore(Recovered recovered);
    /// Stops all timers; the master is shutting down.
    void close();

    /// Random id of this cluster, which the journal keeps across restarts.
    [[nodiscard]] const Sha256& cluster() const { return cluster_; }
    [[nodiscard]] const CoordinatorParts& parts() const { return parts_; }
    [[nodiscard]] WorkerDirectory& workers() { return state_.workers; }
    [[nodiscard]] WorkerDesk& worker_desk() { return worker_desk_; }
    [[nodiscard]] const WorkerDesk& worker_desk() const { return worker_desk_; }
    [[nodiscard]] JobDesk& jobs() { return job_desk_; }
    [[nodiscard]] const JobDesk& jobs() const { return job_desk_; }
    /// Alarms and quarantined processes, including those from before restarts of the master.
    [[nodiscard]] const Alarms& alarms() const { return state_.alarms; }

    /// Aborts if an invariant is broken. For tests; call it between two events.
    void check_invariants() const;

  private:
    using Authors = std::map<InstanceId, std::shared_ptr<const Author>>;

    /// Restores the poses, results and disputes of a running job. `known`: all authors found so
    /// far; this adds the job's.
    [[nodiscard]] Status restore_run(MasterJob& job, RecoveredJob& found, Authors& known);
    /// Holds resumed jobs back for a time, until the workers from before the restart return.
    void await_workers();

    // Callbacks for what the journal has committed.
    [[nodiscard]] JournalWriter::Events journal_events();
    void job_ended(JobId job);
    void job_dropped(JobId job);

    // Actions that the dispatcher asks for.
    void perform(const Action& action);
    void give_up(const GiveUp& action);

    CoordinatorParts parts_;
    MasterState state_;
    MasterServices services_;
    WorkerDesk worker_desk_;
    JobDesk job_desk_;
    Sha256 cluster_;
    bool is_closed_ = false;
};

} // namespace cd
