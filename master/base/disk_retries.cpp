#include "master/base/disk_retries.hpp"

#include "common/core/timing/master.hpp"

#include <utility>

namespace cd {

void DiskRetries::start(JobId job, std::function<void()> again) {
    if (is_closed_) {
        return;
    }
    const auto step = std::make_shared<const std::function<void()>>(std::move(again));
    const auto place = waiting_.emplace(job, step);
    loop_.after(timing::journal_retry_period, [this, place, weak = std::weak_ptr(step)] {
        if (const auto due = weak.lock()) { // Null if the step was stopped or dropped meanwhile.
            waiting_.erase(place);
            (*due)();
        }
    });
}

void DiskRetries::stop(JobId job) {
    const auto [begin, end] = waiting_.equal_range(job);
    for (auto step = begin; step != end; ++step) {
        loop_.post([again = *step->second] { again(); });
    }
    waiting_.erase(begin, end);
}

} // namespace cd
