// Hands out order positions without analysis, and takes back those that were not answered.
#pragma once

#include "master/base/background.hpp"
#include "master/dispatch/dispatch_driver.hpp"
#include "master/jobs/job_life.hpp"
#include "master/jobs/job_table.hpp"
#include "master/jobs/work/lease_book.hpp"
#include "master/journal/journal_writer.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace cd {

/// All positions of a running job without a result are in its `todo`, at the dispatcher, or in a
/// task.
class RangeFeed {
  public:
    struct Parts {
        JobTable& jobs;
        JobLife& life;
        LeaseBook& tasks;
        DispatchDriver& dispatch;
        JournalWriter& writer;
        Background& background;
    };

    /// All parts outlive the feed.
    explicit RangeFeed(const Parts& parts) : parts_(parts) {}

    /// Gives the dispatcher positions of the job until it has enough. The job has work.
    void give(MasterJob& job);
    /// Takes back what the dispatcher has not sent.
    void take_back(MasterJob& job);
    /// Queues scenarios whose results were withdrawn. The job has work.
    void give_again(MasterJob& job, std::vector<std::uint64_t> scenarios);

    // ---- Actions of the dispatcher ------------------------------------------------------------
    void ended(const RangeEnded& range);
    void given_back(const GivenBack& given);
    /// Journals the losses, so that a restart does not retry a worker-killing scenario from zero.
    void lost(const ScenariosLost& lost);

  private:
    using Window = std::shared_ptr<const PoseWindow>;

    void came(JobId job, const PlaceRange& places, const Result<Window>& window);
    /// Gives the dispatcher those of the positions that have no result.
    void give(MasterJob& job, const GivenPlaces& given);
    /// Queues those positions that have no result and are in no task.
    void requeue(MasterJob& job, const GivenPlaces& ended, LostWith lost_with);
    void give_again(MasterJob& job, const Window& window, std::vector<std::uint64_t> scenarios);
    void write_losses(MasterJob& job, std::vector<LostPlaces> losses);

    Parts parts_;
};

} // namespace cd
