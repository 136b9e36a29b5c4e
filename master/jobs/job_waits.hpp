// Lets coroutines wait until the acceptance, the end or the removal of a job is durable.
#pragma once

#include "common/core/id.hpp"
#include "proto/channel/asio.hpp"

#include <map>
#include <memory>

namespace cd {

/// Lists the timers to cancel at the next durable event of each job. All members run on the
/// executor's thread.
class JobWaits {
  public:
    using Time = asio::steady_timer::time_point;

    explicit JobWaits(asio::any_io_executor executor) : executor_(std::move(executor)) {}

    /// Cancels the timer at the job's next event, if the timer still exists then.
    void notify(JobId job, const std::shared_ptr<asio::steady_timer>& timer);
    /// Returns true at the job's next event, or false at `until`.
    [[nodiscard]] asio::awaitable<bool> wait(JobId job, Time until = Time::max());
    /// Reports an event: ends all waits for the job.
    void wake(JobId job);

  private:
    asio::any_io_executor executor_;
    std::multimap<JobId, std::weak_ptr<asio::steady_timer>> waiting_;
};

} // namespace cd
