// Retries steps of jobs that failed because of the disk.
#pragma once

#include "common/core/id.hpp"
#include "common/core/timing/master.hpp"
#include "master/base/event_loop.hpp"

#include <functional>
#include <map>
#include <memory>

namespace cd {

/// Somebody may repair a full or damaged disk, so a step is tried again after
/// `timing::journal_retry_period`. All members run on the loop's thread.
class DiskRetries {
  public:
    /// The loop outlives this object, and is closed before this object is destroyed.
    explicit DiskRetries(EventLoop& loop) : loop_(loop) {}
    DiskRetries(const DiskRetries&) = delete;
    DiskRetries& operator=(const DiskRetries&) = delete;

    /// Calls `again` after the retry period, or soon after `stop`, but not after `close`.
    void start(JobId job, std::function<void()> again);
    /// True if a step of the job waits for its retry.
    [[nodiscard]] bool any(JobId job) const { return waiting_.contains(job); }
    /// Ends all waits of a job that has ended: the steps run soon, and find no running job.
    void stop(JobId job);
    /// Drops all waiting steps. Later calls of `start` do nothing.
    void close() {
        is_closed_ = true;
        waiting_.clear();
    }

  private:
    using Step = std::shared_ptr<const std::function<void()>>;

    EventLoop& loop_;
    std::multimap<JobId, Step> waiting_;
    bool is_closed_ = false;
};

} // namespace cd
