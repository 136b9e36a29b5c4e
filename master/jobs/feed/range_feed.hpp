// Gives positions of a job to the dispatcher without analysis, and queues positions again that were
// lost or whose results were withdrawn.
#pragma once

#include "master/base/background.hpp"
#include "master/dispatch/dispatch_driver.hpp"
#include "master/jobs/job_life.hpp"
#include "master/jobs/job_table.hpp"
#include "master/journal/journal_writer.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace cd {

/// Each position without a result is in the job's `todo`, in an analysis, or at the dispatcher.
class RangeFeed {
  public:
    struct Parts {
        JobTable& jobs;
        JobLife& life;
        DispatchDriver& dispatch;
        JournalWriter& writer;
        Background& background;
    };

    /// All parts outlive the feed.
    explicit RangeFeed(const Parts& parts) : parts_(parts) {}

    /// Gives the dispatcher positions of the job until it has enough. The job must have work.
    void give(MasterJob& job);
    /// Takes back the job's positions that the dispatcher has not sent.
    void take_back(MasterJob& job);
    /// Queues scenarios whose results were withdrawn. The job must have work.
    void give_again(MasterJob& job, std::vector<std::uint64_t> scenarios);
    /// Writes losses to the journal. Otherwise a scenario that kills workers would get all its
    /// attempts again after a restart. Queues positions that were lost without analysis.
    void lost(const PositionsLost& lost);

  private:
    using Window = std::shared_ptr<const PoseWindow>;

    void came(JobId job, const PositionRange& positions, const Result<Window>& window);
    /// Gives the dispatcher the positions that have no result and are not analysed.
    void give(MasterJob& job, const GivenRange& range);
    void give_again(MasterJob& job, const Window& window, std::vector<std::uint64_t> scenarios);

    Parts parts_;
};

} // namespace cd
