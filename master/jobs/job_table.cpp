#include "master/jobs/job_table.hpp"

#include "common/core/check.hpp"
#include "common/core/host/log.hpp"
#include "common/core/host/wall_clock.hpp"
#include "common/core/limits/master.hpp"
#include "master/submission/submission.hpp"

#include <algorithm>
#include <tuple>

namespace cd {

MasterJob::MasterJob(RecoveredJob recovered, Clock::time_point now)
    : id(recovered.record.id),
      submit(std::move(recovered.record.submit)),
      began(recovered.record.began),
      started(now),
      seconds_before(recovered.progress.seconds),
      state(recovered.end ? recovered.end->state : JobState::Running),
      merged(std::move(recovered.merger)),
      results(std::move(recovered.results)),
      losses_before(std::move(recovered.losses)),
      end(std::move(recovered.end)),
      ended(now),
      contributors(std::move(recovered.contributors)),
      answered_by_master(recovered.progress.answered_by_master),
      withdrawn(recovered.withdrawn),
      statistics(recovered.progress.statistics),
      compute_seconds(recovered.progress.compute_seconds),
      traffic(recovered.progress.traffic),
      help(recovered.progress.help),
      depths(std::move(recovered.progress.depths)),
      map(std::move(recovered.map)) {
    if (end) {
        drop_bulk(submit);
    }
}

GivenPlaces MasterJob::take_given(const PlaceRange& places) {
    // The leading part may be returned and given again before the rest is taken.
    auto found = given.extract(places.first);
    CD_CHECK(!found.empty());
    GivenPlaces& left = found.mapped();
    CD_CHECK(places.count <= left.places.count);
    const GivenPlaces taken{places, left.window};
    left.places = {places.end(), left.places.count - places.count};
    if (left.places.count != 0) {
        found.key() = left.places.first;
        const bool is_new = given.insert(std::move(found)).inserted;
        CD_CHECK(is_new);
    }
    return taken;
}

JobProgress MasterJob::progress(Clock::time_point now) const {
    const std::chrono::duration<double> running = (is_running() ? now : ended) - started;
    return {seconds_before + running.count(),
            answered_by_master,
            statistics,
            compute_seconds,
            traffic,
            help,
            depths,
            map.withdrawn()};
}

JobStatus MasterJob::status(Clock::time_point now) const {
    JobStatus status;
    status.job = id;
    status.name = submit.name;
    status.state = state;
    status.summary = merged.summary();
    status.seconds = progress(now).seconds;
    if (status.seconds > 0) {
        status.scenarios_per_second = static_cast<double>(status.summary.merged()) / status.seconds;
    }
    if (state != JobState::Running) {
        status.digest = end->digest;
        status.failure = end->failure;
    }
    for (const JobBody& body : submit.bodies) {
        status.bodies.push_back(body.mesh);
    }
    status.paused = paused;
    status.answered_by_master = answered_by_master;
    status.statistics = statistics;
    status.compute_seconds = compute_seconds;
    status.withdrawn = withdrawn;
    status.recalled = help.recalled;
    status.copies = help.copies;
    status.copies_won = help.copies_won;
    status.traffic = traffic;
    status.depths = depths;
    status.owner = submit.owner;
    status.began = began;
    return status;
}

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
    CD_CHECK(job.is_running());
    CD_CHECK(state != JobState::Running);
    job.ended = now;
    job.end = JobEnd{state, failure, {}, unix_seconds()};
    if (state == JobState::Done) {
        job.end->digest = job.merged.digest();
        CD_CHECK(job.end->digest.has_value());
    }
    job.contributors = job.merged.processes();
    job.merged.close();
    job.analyser.reset();
    job.analysis_input.reset();
    job.material.reset();
    drop_bulk(job.submit);
    job.poses.reset();
    job.paused.clear();
    job.open.clear();
    job.given.clear();
    job.losses_before = {};
    job.todo = PlaceQueue();
    job.order.reset();
    job.done.reset();
    job.disputes_left = {};
    job.cancelled = {};
    job.map.finish();
    running_.erase(job.id);
}

std::vector<JobId> JobTable::announce(MasterJob& job) {
    CD_CHECK(!job.is_running());
    job.state = job.end->state;
    ++job.changes;
    // The oldest job is the one that ended first, not the one with the lowest id.
    std::vector<std::tuple<Clock::time_point, JobId, std::uint64_t>> ended;
    std::uint64_t results = 0;
    for (const auto& [id, one] : jobs_) {
        if (one.state != JobState::Running) {
            ended.emplace_back(one.ended, id, one.merged.summary().merged());
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
        if (job.state != JobState::Running &&
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
