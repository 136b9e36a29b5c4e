#include "master/coordinator/status_view.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"
#include "common/core/version.hpp"

#include <sys/resource.h>

namespace cd {

namespace {

double seconds_of(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

} // namespace

Result<JobStatus> StatusView::job(JobId id) const {
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        return no_job();
    }
    JobStatus status = job->status(now_);
    add_what_it_waits_for(status);
    return status;
}

ClusterStatus StatusView::cluster() const {
    ClusterStatus status;
    status.build = version;
    status.cpu_seconds = cpu_seconds();
    status.workers = workers_.statuses();
    status.jobs = jobs_.statuses(now_);
    for (JobStatus& job : status.jobs) {
        add_what_it_waits_for(job);
    }
    status.alarms = alarms_.record().last;
    status.alarm_count = alarms_.record().count;
    status.losses.workers_lost = workers_.counts().lost;
    status.losses.sessions_resumed = workers_.counts().resumed;
    status.losses.scenarios_given_back = workers_.counts().given_back;
    return status;
}

void StatusView::add_what_it_waits_for(JobStatus& status) const {
    if (status.state != JobState::Running) {
        return;
    }
    if (!paused_.empty()) {
        status.paused = paused_;
    }
    for (const auto& [id, worker] : workers_.all()) {
        const auto& longest = worker.meter.longest();
        if (longest && longest->job == status.job &&
            longest->seconds >= timing::scenario_seconds_shown &&
            status.long_scenarios.size() < limits::long_scenarios_shown) {
            status.long_scenarios.push_back(
                {longest->scenario, id, worker.author->name, longest->seconds});
        }
    }
}

} // namespace cd
