// Excludes worker processes that gave a wrong result, and withdraws their results.
#pragma once

#include "master/blocks/block_delivery.hpp"
#include "master/dispatch/dispatch_driver.hpp"
#include "master/jobs/feed/range_feed.hpp"
#include "master/jobs/feed/task_exchange.hpp"
#include "master/jobs/job_table.hpp"
#include "master/journal/journal_writer.hpp"
#include "master/verify/alarms.hpp"
#include "master/workers/worker_directory.hpp"

namespace cd {

/// A process in quarantine gets no more work. Running jobs drop all its results. An alarm names the
/// ended jobs that have results of the process.
class Quarantine {
  public:
    struct Parts {
        JobTable& jobs;
        WorkerDirectory& workers;
        BlockDelivery& blocks;
        TaskExchange& tasks;
        RangeFeed& ranges;
        DispatchDriver& dispatch;
        Alarms& alarms;
        JournalWriter& writer;
    };

    /// All parts outlive this object.
    explicit Quarantine(const Parts& parts) : parts_(parts) {}

    /// Quarantines the process that gave a wrong result, unless it is in quarantine already.
    void impose(const Author& wrong);
    /// Withdraws the results of a process in quarantine from a running job, and hands their
    /// scenarios out again.
    void withdraw_results(const Author& wrong, MasterJob& job);

  private:
    void warn_of_ended_jobs(const Author& wrong);

    Parts parts_;
};

/// Marks the job's map, or its sums by part, as unusable, if it has any. `why` is shown to users.
void withdraw_map(MasterJob& job, const std::string& why);

} // namespace cd
