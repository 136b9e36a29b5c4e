// Retries steps of jobs that failed because of the disk.
#pragma once

#include "common/core/id.hpp"
#include "common/core/timing/master.hpp"
#include "proto/channel/asio.hpp"

#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace cd {

/// Somebody may repair a full or damaged disk, so a step is tried again after
/// `timing::journal_retry_period`. All members run on the executor's thread.
class DiskRetries {
  public:
    explicit DiskRetries(asio::any_io_executor executor) : executor_(std::move(executor)) {}
    DiskRetries(const DiskRetries&) = delete;
    DiskRetries& operator=(const DiskRetries&) = delete;
    ~DiskRetries() { close(); }

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
    struct Step {
        asio::steady_timer timer;
        std::function<void()> again;
    };
    asio::any_io_executor executor_;
    std::multimap<JobId, std::shared_ptr<Step>> waiting_;
    bool is_closed_ = false;
};

} // namespace cd
