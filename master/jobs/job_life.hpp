// Ends jobs, and pauses them while the disk is full or damaged. A paused job keeps all its data,
// and resumes once the disk works again.
#pragma once

#include "common/core/result.hpp"
#include "master/base/disk_retries.hpp"
#include "master/blocks/block_delivery.hpp"
#include "master/dispatch/dispatch_driver.hpp"
#include "master/geometry/tree_registry.hpp"
#include "master/jobs/job_table.hpp"
#include "master/journal/journal_writer.hpp"
#include "master/workers/worker_directory.hpp"

#include <functional>
#include <string>

namespace cd {

class JobLife {
  public:
    struct Events {
        /// Called before a job ends, so that work on the job can stop.
        std::function<void(JobId)> ending;
        /// Called after a retry of a step that a disk error had stopped.
        std::function<void()> retried;
    };
    struct Parts {
        JobTable& jobs;
        WorkerDirectory& workers;
        TreeRegistry& trees;
        BlockDelivery& blocks;
        DispatchDriver& dispatch;
        JournalWriter& writer;
        DiskRetries& retries;
    };

    /// All parts outlive this object.
    JobLife(const Parts& parts, Events events) : parts_(parts), events_(std::move(events)) {}

    [[nodiscard]] Clock::time_point now() const { return parts_.jobs.now(); }
    /// Ends a running job in the job table, at the dispatcher and on the workers. Writes the end to
    /// the journal.
    void end(MasterJob& job, JobState state, const std::string& failure);
    /// Ends a running job that has all its results and no dispute.
    void end_if_complete(MasterJob& job);

    /// Pauses the job after a disk error and calls `again` a little later. A paused job prepares no
    /// more work. Any other error fails the job. `again` gets null if the job has ended.
    void wait_for_disk(MasterJob& job, const Error& why, std::function<void(MasterJob*)> again);
    /// Call when a step of the running job has succeeded on the disk. Resumes the job unless
    /// another of its steps still waits.
    void disk_gives(MasterJob& job);
    /// True if a step of the job waits for a retry after a disk error.
    [[nodiscard]] bool is_waiting(JobId job) const { return parts_.retries.any(job); }

  private:
    void release_tree(TreeId tree);

    Parts parts_;
    Events events_;
};

} // namespace cd
