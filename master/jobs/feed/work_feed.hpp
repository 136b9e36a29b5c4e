// Chooses the jobs' next work: analyses to start, or ranges sent without analysis. Jobs of higher
// priority come first. Of equal ones, owners get the same time of the pool's threads.
#pragma once

#include "master/base/background.hpp"
#include "master/base/event_loop.hpp"
#include "master/jobs/feed/analysis_feed.hpp"
#include "master/jobs/feed/range_feed.hpp"
#include "master/jobs/job_table.hpp"
#include "master/workers/awaited_workers.hpp"
#include "master/workers/worker_directory.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

class WorkFeed {
  public:
    struct Parts {
        EventLoop& loop;
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
    using Jobs = std::vector<MasterJob*>;

    /// Jobs that may get work, in the order of their turns. Adds the load of all jobs to `load`.
    [[nodiscard]] Jobs jobs_to_feed(Load& load);
    /// Starts analyses of these jobs, one after the other, while they want more and there is room.
    /// `unsent_max`: number of unsent scenarios of one job that leaves workers enough choice.
    void analyse(std::span<MasterJob* const> jobs, std::uint64_t unsent_max, Load& load);
    [[nodiscard]] bool has_room_for_analysis(const Load& load) const;
    /// True if the job's unsent scenarios, with those in analysis, are fewer than `unsent_max`.
    [[nodiscard]] bool
    wants_more(const MasterJob& job, std::uint64_t unsent_max, const Load& load) const;
    [[nodiscard]] bool prefers_ranges_now(const MasterJob& job) const;
    /// If positions of these jobs wait and a worker is idle, calls `feed` after a time. With many
    /// workers an event only causes a look at the one it is about, which may not take them, and no
    /// event may follow.
    void look_again(const Jobs& jobs);

    Parts parts_;
    bool looks_again_ = false; ///< `look_again` has set a timer.
};

} // namespace cd
