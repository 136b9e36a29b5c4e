// Hands out positions of a job without analysis, and takes back those without an answer.
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

/// Keeps each position without a result in the job's `todo`, at the dispatcher, or in a task.
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

    /// Gives the dispatcher positions of the job until it has enough. The job must have work.
    void give(MasterJob& job);
    /// Takes back the job's positions that the dispatcher has not sent.
    void take_back(MasterJob& job);
    /// Queues scenarios whose results were withdrawn. The job must have work.
    void give_again(MasterJob& job, std::vector<std::uint64_t> scenarios);

    // ---- Actions of the dispatcher ------------------------------------------------------------
    void ended(const RangeEnded& range);
    void given_back(const GivenBack& given);
    /// Writes the losses to the journal. Otherwise a scenario that kills workers would get all its
    /// attempts again after a restart.
    void lost(const ScenariosLost& lost);

  private:
    using Window = std::shared_ptr<const PoseWindow>;

    void came(JobId job, const PlaceRange& places, const Result<Window>& window);
    /// Gives the dispatcher the positions that have no result.
    void give(MasterJob& job, const GivenPlaces& given);
    /// Queues the positions of an ended range that have no result and are in no other task.
    void requeue(MasterJob& job, const GivenPlaces& ended, LostWith lost_with);
    void give_again(MasterJob& job, const Window& window, std::vector<std::uint64_t> scenarios);
    void write_losses(MasterJob& job, std::vector<LostPlaces> losses);

    Parts parts_;
};

} // namespace cd
