#include "master/base/disk_retries.hpp"

#include "common/core/timing/master.hpp"

namespace cd {

void DiskRetries::start(JobId job, std::function<void()> again) {
    if (is_closed_) {
        return;
    }
    const auto step = std::make_shared<Step>(
        Step{asio::steady_timer(executor_, timing::journal_retry_period), std::move(again)});
    const auto place = waiting_.emplace(job, step);
    step->timer.async_wait(
        [this, place, weak = std::weak_ptr(step)](const boost::system::error_code& error) {
            const auto due = weak.lock(); // Null if the step was stopped or dropped meanwhile.
            if (!error && due != nullptr) {
                waiting_.erase(place);
                due->again();
            }
        });
}

void DiskRetries::stop(JobId job) {
    const auto [begin, end] = waiting_.equal_range(job);
    for (auto step = begin; step != end; ++step) {
        asio::post(executor_, [again = std::move(step->second->again)] { again(); });
    }
    waiting_.erase(begin, end);
}

} // namespace cd
