#include "master/coordinator/job_desk.hpp"

#include "common/core/host/log.hpp"
#include "master/coordinator/growth_view.hpp"

#include <chrono>
#include <utility>

namespace cd {

Result<JobId> JobDesk::allot(std::uint64_t scenarios) {
    if (!paused().empty()) {
        return Error{ErrorCode::Io, "the master takes no jobs now: " + paused()};
    }
    return state_.jobs.next(scenarios);
}

void JobDesk::begin(const JobRecord& record,
                    std::shared_ptr<ResultStore> results,
                    std::shared_ptr<OrderedPoses> poses) {
    services_.start.begin(record, std::move(results), std::move(poses));
}

Result<std::uint64_t> JobDesk::set_priority(JobId id, std::int32_t priority) {
    MasterJob* job = state_.jobs.find(id);
    if (job == nullptr) {
        return no_job();
    }
    if (!job->is_running()) {
        return Error{ErrorCode::Refused, "the job has ended"};
    }
    if (!paused().empty()) {
        return Error{ErrorCode::Io, "no priority can be changed now: " + paused()};
    }
    log_info("priority changed: job={} from={} to={}", id.value, job->submit.priority, priority);
    job->submit.priority = priority;
    ++job->changes;
    const std::uint64_t position =
        state_.writer.write(ChangeJob{{id, job->submit, job->times.began}});
    if (job->work() != nullptr) {
        state_.dispatch.act(state_.dispatch->job_ranked(id, priority));
    }
    services_.work.feed();
    return position;
}

Result<JobStatus> JobDesk::cancel(JobId id) {
    MasterJob* job = state_.jobs.find(id);
    if (job == nullptr) {
        return no_job();
    }
    if (job->is_running()) {
        services_.life.end(*job, JobState::Cancelled, "cancelled");
        services_.work.feed();
    }
    return status(id);
}

Status JobDesk::forget(JobId id) {
    const MasterJob* job = state_.jobs.find(id);
    if (job == nullptr) {
        return no_job();
    }
    if (job->state() == JobState::Running) {
        return Error{ErrorCode::Refused, "the job is running"};
    }
    if (!paused().empty()) {
        return Error{ErrorCode::Io, "nothing can be removed now: " + paused()};
    }
    state_.jobs.drop(id);
    state_.writer.write(DropJob{id});
    return Done{};
}

void JobDesk::forget_expired(std::uint64_t now) {
    if (!paused().empty()) {
        return;
    }
    for (const JobId job : state_.jobs.drop_expired(now)) {
        state_.writer.write(DropJob{job});
    }
}

bool JobDesk::cancel_disputed(JobId job, std::uint64_t scenario) {
    if (!services_.references.stop(job, scenario)) {
        return false;
    }
    log_warning("scenario in dispute cancelled: job={} scenario={}", job.value, scenario);
    return true;
}

Result<std::shared_ptr<OrderedPoses>> JobDesk::poses_of_unanswered(JobId id,
                                                                   std::uint64_t scenario) {
    const MasterJob* job = state_.jobs.find(id);
    if (job == nullptr) {
        return no_job();
    }
    const std::string name = "scenario " + std::to_string(scenario);
    if (scenario >= job->merged.summary().total) {
        return Error{ErrorCode::NotFound, "the job has no " + name};
    }
    if (!job->is_running() || job->merged.has(scenario)) {
        return Error{ErrorCode::Refused, name + " has a result, or the job has ended"};
    }
    return job->run->poses;
}

Status JobDesk::cancel_scenario(JobId id, const PlacedScenario& placed) {
    const std::uint64_t index = placed.scenario.index;
    if (const auto poses = poses_of_unanswered(id, index); !poses) {
        return poses.error();
    }
    log_warning("scenario cancelled: job={} scenario={}", id.value, index);
    services_.merger.fail(state_.jobs.at(id), placed, "cancelled");
    MasterJob* still = state_.jobs.find_running(id);
    if (still != nullptr && still->work() != nullptr) {
        still->work()->cancelled.push_back(index);
        services_.tasks.drop(id, index);
        state_.dispatch.act(
            state_.dispatch->answered({{}, {}, id, PositionRange{placed.position, 1}}));
    }
    services_.work.feed();
    return Done{};
}

Result<JobStatus> JobDesk::status(JobId job) const {
    Result<JobStatus> status = view().job(job);
    if (status) {
        status.value().turn.share = state_.dispatch.view().share(job);
    }
    return status;
}

StatusView JobDesk::view() const {
    return {state_.jobs, state_.workers, state_.alarms, paused(), state_.loop.now()};
}

ClusterStatus JobDesk::cluster() const {
    ClusterStatus status = view().cluster();
    status.uptime_seconds = std::chrono::duration<double>(state_.loop.now() - started_).count();
    status.meshes = geometry_.meshes();
    status.growth = growth_of(state_.jobs,
                              state_.dispatch.view(),
                              {services_.merger.seconds_each(),
                               static_cast<double>(state_.background.compute_pool().size())});
    for (JobStatus& job : status.jobs) {
        job.turn.share = state_.dispatch.view().share(job.job);
    }
    return status;
}

Explainer JobDesk::explainer() const {
    return {state_.jobs, state_.dispatch.view(), [&workers = state_.workers](WorkerId worker) {
                return workers.find(worker) != nullptr;
            }};
}

Result<ContactMapAnswer> JobDesk::contact_map(const ContactMapQuery& query) const {
    const MasterJob* job = state_.jobs.find(query.job);
    if (job == nullptr) {
        return no_job();
    }
    if (!query.only_parts && job->state() != JobState::Done) {
        return Error{ErrorCode::Refused, "the job is not done, so it has no map"};
    }
    return ContactMapAnswer{job->id,
                            query.only_parts ? sums_contacts(job->submit) : job->submit.query.maps,
                            job->map.withdrawn(),
                            query.only_parts ? job->map.packed_parts() : job->map.packed()};
}

} // namespace cd
