#include "master/jobs/job_waits.hpp"

namespace cd {

void JobWaits::notify(JobId job, const std::shared_ptr<asio::steady_timer>& timer) {
    std::erase_if(waiting_, [](const auto& waiting) { return waiting.second.expired(); });
    waiting_.emplace(job, timer);
}

asio::awaitable<bool> JobWaits::wait(JobId job, Time until) {
    const auto timer = std::make_shared<asio::steady_timer>(executor_, until);
    notify(job, timer);
    boost::system::error_code woken;
    co_await timer->async_wait(asio::redirect_error(asio::use_awaitable, woken));
    co_return bool(woken);
}

void JobWaits::wake(JobId job) {
    const auto [begin, end] = waiting_.equal_range(job);
    for (auto waiting = begin; waiting != end; ++waiting) {
        if (const auto timer = waiting->second.lock()) {
            timer->cancel();
        }
    }
    waiting_.erase(begin, end);
}

} // namespace cd
