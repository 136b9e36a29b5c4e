// Chooses the jobs' next work: analyses to start, or ranges sent without analysis.
#pragma once

#include "master/base/background.hpp"
#include "master/jobs/feed/analysis_feed.hpp"
#include "master/jobs/feed/range_feed.hpp"
#include "master/jobs/job_table.hpp"
#include "master/workers/awaited_workers.hpp"
#include "master/workers/worker_directory.hpp"

#include <cstdint>
#include <vector>

namespace cd {

class WorkFeed {
  public:
    struct Parts {
        JobTable& jobs;
        const WorkerDirectory& workers;
        const AwaitedWorkers& awaited;
        JobLife& life;
        DispatchDriver& dispatch;
        const JournalWriter& writer;
        Background& background;
        RangeFeed& ranges;
        AnalysisFeed& analyses;
        FeedLimits limits;
    };

    /// All parts outlive the feed.
    explicit WorkFeed(const Parts& parts) : parts_(parts) {}

    /// Starts analyses and gives ranges to the dispatcher while there is room. Tells the dispatcher
    /// when no analysis is under way. Call after each event.
    void feed();

  private:
    /// Load of the thread pool and of the memory by analyses.
    struct Load {
        std::uint64_t under_way = 0;  ///< Blocks (`AnalysedBlock`) in analysis, of all jobs.
        std::uint64_t open_bytes = 0; ///< Memory of the open analyses of all jobs.
    };
    /// Jobs that may get work, in the order of their turns. Adds the load of all jobs to `load`.
    [[nodiscard]] std::vector<MasterJob*> jobs_to_feed(Load& load);
    [[nodiscard]] bool has_room_for_analysis(const Load& load) const;
    /// True if `under_way` more scenarios still leave workers too little choice.
    [[nodiscard]] bool wants_more(std::uint64_t under_way) const;
    [[nodiscard]] bool prefers_ranges_now(const MasterJob& job) const;

    Parts parts_;
    JobId fed_last_;
};

} // namespace cd
