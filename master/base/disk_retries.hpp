// Steps of jobs that failed on the disk and are tried again.
#pragma once

#include "common/core/id.hpp"
#include "proto/channel/asio.hpp"

#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace cd {

/// A full or damaged disk may be mended, so a step is tried again after
/// `limits::journal_retry_period`. All members run on the executor's thread.
class DiskRetries {
  public:
    explicit DiskRetries(asio::any_io_executor executor) : executor_(std::move(executor)) {}
    DiskRetries(const DiskRetries&) = delete;
    DiskRetries& operator=(const DiskRetries&) = delete;
    ~DiskRetries() { close(); }

    /// Calls `again` after a while, or soon after `stop`; never after `close`.
    void start(JobId job, std::function<void()> again);
    /// A step of the job waits.
    [[nodiscard]] bool any(JobId job) const { return waiting_.contains(job); }
    /// Ends the waits of a job: it has ended, so its steps find that out.
    void stop(JobId job);
    /// Drops all steps, also those that would be started later.
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
