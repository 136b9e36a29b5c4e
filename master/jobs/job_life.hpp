// Ends jobs, and lets them wait for the disk. A full or damaged disk may be mended; waiting loses
// nothing, and nothing is deleted.
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
        /// The job is about to end: work on it may stop.
        std::function<void(JobId)> ending;
        /// A step that failed on the disk was tried again.
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

    /// All parts outlive it.
    JobLife(const Parts& parts, Events events) : parts_(parts), events_(std::move(events)) {}

    /// Ends a running job everywhere, and writes its end to the journal.
    void end(MasterJob& job, JobState state, const std::string& failure);
    /// Ends a running job that has all its results and no dispute.
    void end_if_complete(MasterJob& job);

    /// Pauses the job after a disk error and calls `again` a little later. A paused job prepares no
    /// more work. Any other error fails the job. `again` gets null if the job has ended.
    void wait_for_disk(MasterJob& job, const Error& why, std::function<void(MasterJob*)> again);
    /// Reports that the disk works again for the running job.
    void disk_gives(MasterJob& job);
    /// A step of the job waits for the disk.
    [[nodiscard]] bool is_waiting(JobId job) const { return parts_.retries.any(job); }

  private:
    void release_tree(TreeId tree);

    Parts parts_;
    Events events_;
};

} // namespace cd
