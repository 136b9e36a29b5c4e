// Ingests workers' results: checks them on a pool, merges them, and has them acknowledged once they
// are durable.
//
// Late results belong to no current task: their session or their job has ended. While their job
// runs, they are checked and merged; after its end, they are only acknowledged.
#pragma once

#include "master/base/background.hpp"
#include "master/compute/reference_run.hpp"
#include "master/dispatch/dispatch_driver.hpp"
#include "master/jobs/feed/task_exchange.hpp"
#include "master/jobs/job_life.hpp"
#include "master/jobs/job_merger.hpp"
#include "master/jobs/job_table.hpp"
#include "master/results/parked_results.hpp"
#include "master/verify/alarms.hpp"
#include "master/workers/awaited_workers.hpp"
#include "master/workers/worker_directory.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace cd {

class ResultIngest {
  public:
    struct Parts {
        JobTable& jobs;
        JobLife& life;
        JobMerger& merger;
        TaskExchange& tasks;
        WorkerDirectory& workers;
        const Alarms& alarms;
        AwaitedWorkers& awaited;
        DispatchDriver& dispatch;
        JournalWriter& writer;
        Background& background;
    };

    /// All parts outlive this object. `parked_bytes_max`: memory for results that wait. `check`
    /// checks the messages of current tasks.
    ResultIngest(const Parts& parts,
                 std::uint64_t parked_bytes_max,
                 ResultCheck check = take_results)
        : parts_(parts), parked_(parked_bytes_max), check_(std::move(check)) {}

    /// Checks and merges the results, and calls `done` when the journal has room. Invalid results
    /// cut the worker off.
    void came(WorkerId worker, Results results, std::function<void()> done);
    /// Processes the job's waiting results again. Call when its geometry is loaded and when it
    /// ends.
    void take_up(JobId job);
    /// Drops the waiting results of a worker that has left.
    void forget(WorkerId worker) { parked_.forget(worker); }

  private:
    /// Checked results on their way into the job.
    struct Checked {
        IncomingResults incoming;
        std::shared_ptr<const TaskContent> task; ///< Null for late results.
        Result<TakenResults> taken;
        std::vector<std::uint64_t> mapped; ///< Scenarios of the map that the master makes, if any.

        [[nodiscard]] JobId job() const { return incoming.message->job; }
    };
    using Hand = std::shared_ptr<Checked>;

    /// Acknowledges results without merging them.
    void acknowledge(const Author& author, std::uint64_t sequence);
    void late_came(IncomingResults late);
    void check_late(const MasterJob& job, IncomingResults late);
    void late_checked(Hand hand);
    /// Merges checked results. If the job has maps and some scenarios of the message are merged
    /// already, first makes the map of the other scenarios.
    void take_in(const Hand& hand);
    void make_map(const MasterJob& job, const Hand& hand);
    void map_made(const Hand& hand, Result<ContactMap> map);
    void merge(Checked& hand);
    void merge_into(MasterJob& job, Checked& hand);
    /// Adds the cost of the results to the job's tally.
    static void measure(MasterJob& job, const Checked& hand);

    Parts parts_;
    ParkedResults parked_;
    ResultCheck check_;
};

} // namespace cd
