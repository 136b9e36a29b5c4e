#include "master/job_board.hpp"

#include "common/core/check.hpp"
#include "common/core/limits.hpp"
#include "common/core/log.hpp"

#include <algorithm>

namespace cd {

JobStatus MasterJob::status(Clock::time_point now) const {
    JobStatus status;
    status.job = id;
    status.name = submit.name;
    status.state = state;
    status.summary = merger.summary();
    status.digest = digest;
    const auto duration = (is_running() ? now : ended) - accepted;
    status.seconds = std::chrono::duration<double>(duration).count();
    if (status.seconds > 0) {
        status.scenarios_per_second = static_cast<double>(status.summary.merged()) / status.seconds;
    }
    status.failure = failure;
    std::copy_n(submit.bodies.begin(),
                std::min<std::size_t>(2, submit.bodies.size()),
                status.bodies.begin());
    status.answered_by_master = answered_by_master;
    status.statistics = statistics;
    status.compute_seconds = compute_seconds;
    return status;
}

Result<MasterJob*>
JobBoard::add(Submit submit, std::shared_ptr<ResultStore> results, Clock::time_point now) {
    if (running_.size() >= limits::jobs_running_max) {
        return Error{ErrorCode::Refused,
                     std::to_string(running_.size()) + " jobs are running; submit again later"};
    }
    const JobId id{++last_};
    const auto place = jobs_.try_emplace(id, id, std::move(submit), std::move(results), now).first;
    running_.insert(id);
    return &place->second;
}

MasterJob* JobBoard::find(JobId job) {
    const auto found = jobs_.find(job);
    return found == jobs_.end() ? nullptr : &found->second;
}

MasterJob* JobBoard::find_running(JobId id) {
    MasterJob* job = find(id);
    return job != nullptr && job->is_running() ? job : nullptr;
}

void JobBoard::end(MasterJob& job,
                   JobState state,
                   const std::string& failure,
                   Clock::time_point now) {
    CD_CHECK(job.is_running());
    CD_CHECK(state != JobState::Running);
    job.state = state;
    job.failure = failure;
    job.ended = now;
    if (state == JobState::Done) {
        job.digest = job.merger.digest();
        CD_CHECK(job.digest.has_value());
    }
    job.submitter.reset();
    job.analysis_input.reset();
    job.material.reset();
    job.open.clear();
    job.given.clear();
    job.todo = PlaceQueue();
    job.order.reset();
    ++job.changes;
    running_.erase(job.id);
    drop_oldest_ended();
}

void JobBoard::drop_oldest_ended() {
    if (jobs_.size() - running_.size() <= limits::jobs_ended_kept_max) {
        return;
    }
    const auto oldest = std::find_if(
        jobs_.begin(), jobs_.end(), [](const auto& entry) { return !entry.second.is_running(); });
    spdlog::info("results dropped: job={} reason=\"newer jobs\"", oldest->first.value);
    jobs_.erase(oldest);
}

std::vector<JobStatus> JobBoard::statuses(Clock::time_point now) const {
    std::vector<JobStatus> statuses;
    for (const auto& [id, job] : jobs_) {
        statuses.push_back(job.status(now));
    }
    return statuses;
}

} // namespace cd
