// Jobs that wait for the disk. A full or damaged disk may be mended; waiting loses nothing, and
// nothing is deleted.
#include "common/core/host/log.hpp"
#include "common/core/limits/master.hpp"
#include "master/coordinator/coordinator.hpp"

#include <utility>

namespace cd {

void Coordinator::job_paused(MasterJob& job, const std::string& why) {
    if (why == job.paused) {
        return;
    }
    if (why.empty()) {
        log_info("job goes on: job={}", job.id.value);
    } else if (job.paused.empty()) {
        log_error("job paused, the disk fails: job={} error=\"{}\"", job.id.value, why);
    }
    job.paused = why;
    ++job.changes;
}

void Coordinator::wait_for_disk(MasterJob& job, const Error& why, std::function<void()> again) {
    // Pauses the job at once, not when the coroutine starts.
    spawn(
        parts_.executor, "a job that waits", try_again(begin_to_wait(job, why), std::move(again)));
}

asio::awaitable<void> Coordinator::try_again(std::optional<DiskWait> wait,
                                             std::function<void()> again) {
    if (wait) {
        MasterJob* job = co_await end_of_wait(std::move(*wait));
        if (job != nullptr) {
            again();
            feed();
        }
    }
}

asio::awaitable<MasterJob*> Coordinator::wait_until_mended(JobId id, Error why) {
    std::optional<DiskWait> wait = begin_to_wait(*jobs_.find_running(id), why);
    if (!wait) {
        co_return nullptr;
    }
    const MasterJob* job = co_await end_of_wait(std::move(*wait));
    if (job == nullptr) {
        co_return nullptr;
    }
    feed(); // Other jobs proceed, since the caller's next step may take long.
    co_return jobs_.find_running(id);
}

std::optional<Coordinator::DiskWait> Coordinator::begin_to_wait(MasterJob& job, const Error& why) {
    if (why.code != ErrorCode::Io) {
        end_job(job, JobState::Failed, why.detail);
        return std::nullopt;
    }
    job_paused(job, why.detail);
    if (closed_) {
        return std::nullopt;
    }
    auto timer =
        std::make_shared<asio::steady_timer>(parts_.executor, limits::journal_retry_period);
    return retries_.emplace(job.id, std::move(timer));
}

asio::awaitable<MasterJob*> Coordinator::end_of_wait(DiskWait wait) {
    const JobId id = wait->first;
    boost::system::error_code ignored;
    co_await wait->second->async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    retries_.erase(wait);
    co_return closed_ ? nullptr : jobs_.find_running(id);
}

void Coordinator::disk_gives(MasterJob& job) {
    if (!retries_.contains(job.id)) {
        job_paused(job, "");
    }
}

void Coordinator::stop_waiting(JobId job) {
    const auto [begin, end] = retries_.equal_range(job);
    for (auto retry = begin; retry != end; ++retry) {
        retry->second->cancel();
    }
}

void Coordinator::add_what_it_waits_for(JobStatus& status) const {
    if (status.state != JobState::Running) {
        return;
    }
    if (!paused_.empty()) {
        status.paused = paused_;
    }
    for (const auto& [id, link] : workers_) {
        const auto& longest = link.longest;
        if (longest && longest->job == status.job &&
            longest->seconds >= limits::scenario_seconds_shown &&
            status.long_scenarios.size() < limits::long_scenarios_shown) {
            status.long_scenarios.push_back(
                {longest->scenario, id, link.author->name, longest->seconds});
        }
    }
}

} // namespace cd
