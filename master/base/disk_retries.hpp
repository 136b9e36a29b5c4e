// Retries steps of jobs that failed because of a disk error.
#pragma once

#include "common/core/id.hpp"
#include "common/core/timing/master.hpp"
#include "master/base/event_loop.hpp"

#include <functional>
#include <map>
#include <memory>

namespace cd {

/// Runs a failed step again after `timing::journal_retry_period`, because somebody may repair a
/// full or damaged disk. All members run on the loop's thread.
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
    /// Call when the job has ended: its steps run soon instead of later, and find no running job.
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
