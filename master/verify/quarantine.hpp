// Excludes worker processes that were wrong, and withdraws their results.
#pragma once

#include "master/blocks/block_delivery.hpp"
#include "master/dispatch/dispatch_driver.hpp"
#include "master/jobs/job_table.hpp"
#include "master/jobs/work/range_feed.hpp"
#include "master/jobs/work/task_exchange.hpp"
#include "master/journal/journal_writer.hpp"
#include "master/verify/alarms.hpp"
#include "master/workers/worker_directory.hpp"

namespace cd {

/// A process in quarantine gets no more work, and in running jobs all its results count as never
/// having come. Jobs that have ended are named in an alarm.
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

    /// All parts outlive it.
    explicit Quarantine(const Parts& parts) : parts_(parts) {}

    /// Does nothing if the process is in quarantine already.
    void impose(const Author& wrong);
    /// Withdraws the results of a process in quarantine from a running job, and hands their
    /// scenarios out again.
    void withdraw_results(const Author& wrong, MasterJob& job);

  private:
    void warn_of_ended_jobs(const Author& wrong);

    Parts parts_;
};

/// Marks the map of a job that has one as unusable.
void withdraw_map(MasterJob& job, const std::string& why);

} // namespace cd
