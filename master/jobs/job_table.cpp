#include "master/jobs/job_table.hpp"

#include "common/core/check.hpp"
#include "common/core/host/log.hpp"
#include "common/core/limits/master.hpp"

#include <algorithm>
#include <tuple>

namespace cd {

Error no_job() {
    return {ErrorCode::NotFound, "the master knows no such job"};
}

Result<JobId> JobTable::next(std::uint64_t scenarios) {
    const std::size_t jobs = running_.size() + begun_.size();
    if (jobs >= limits::jobs_running_max) {
        return Error{ErrorCode::Refused,
                     std::to_string(jobs) + " jobs are running; submit again later"};
    }
    std::uint64_t sum = scenarios;
    for (const JobId job : running_) {
        sum += jobs_.at(job).submit.scenarios;
    }
    for (const auto& [job, count] : begun_) {
        sum += count;
    }
    if (sum > limits::scenarios_running_max) {
        return Error{ErrorCode::Refused,
                     "with this one " + std::to_string(sum) +
                         " scenarios would be of jobs that run, and there may be " +
                         std::to_string(limits::scenarios_running_max) + "; submit again later"};
    }
    begun_.emplace(JobId{++last_}, scenarios);
    return JobId{last_};
}

MasterJob& JobTable::add(MasterJob job) {
    const JobId id = job.id;
    reserve(id);
    begun_.erase(id);
    const auto [place, is_new] = jobs_.emplace(id, std::move(job));
    CD_CHECK(is_new);
    if (place->second.is_running()) {
        running_.insert(id);
    }
    return place->second;
}

MasterJob* JobTable::find(JobId job) {
    const auto found = jobs_.find(job);
    return found == jobs_.end() ? nullptr : &found->second;
}

const MasterJob* JobTable::find(JobId job) const {
    const auto found = jobs_.find(job);
    return found == jobs_.end() ? nullptr : &found->second;
}

MasterJob* JobTable::find_running(JobId id) {
    MasterJob* job = find(id);
    return job != nullptr && job->is_running() ? job : nullptr;
}

void JobTable::end(MasterJob& job,
                   JobState state,
                   const std::string& failure,
                   Clock::time_point now) {
    job.finish(state, failure, now);
    running_.erase(job.id);
}

std::vector<JobId> JobTable::announce(MasterJob& job) {
    CD_CHECK(!job.is_running());
    job.is_announced = true;
    ++job.changes;
    // The oldest job is the one that ended first, not the one with the lowest id.
    std::vector<std::tuple<Clock::time_point, JobId, std::uint64_t>> ended;
    std::uint64_t results = 0;
    for (const auto& [id, one] : jobs_) {
        if (one.is_announced) {
            ended.emplace_back(one.times.ended, id, one.merged.summary().merged());
            results += one.merged.summary().merged();
        }
    }
    std::ranges::sort(ended);
    std::size_t left = ended.size();
    std::vector<JobId> dropped;
    for (const auto& [when, id, count] : ended) {
        if (left <= retention_.count && results <= results_kept_) {
            break;
        }
        if (id != job.id) {
            log_info("job forgotten: job={} reason=\"newer jobs\"", id.value);
            dropped.push_back(id);
            jobs_.erase(id);
            results -= count;
            --left;
        }
    }
    return dropped;
}

std::vector<JobId> JobTable::drop_expired(std::uint64_t now) {
    std::vector<JobId> dropped;
    for (const auto& [id, job] : jobs_) {
        if (job.is_announced &&
            retention_.is_over(job.end->ended, job.submit.retention_seconds, now)) {
            log_info("job forgotten: job={} reason=\"its retention is over\"", id.value);
            dropped.push_back(id);
        }
    }
    for (const JobId id : dropped) {
        jobs_.erase(id);
    }
    return dropped;
}

void JobTable::drop(JobId job) {
    CD_CHECK(find(job) != nullptr && !find(job)->is_running());
    jobs_.erase(job);
}

std::vector<JobStatus> JobTable::statuses(Clock::time_point now) const {
    std::vector<JobStatus> statuses;
    for (const auto& [id, job] : jobs_) {
        statuses.push_back(job.status(now));
    }
    return statuses;
}

} // namespace cd
