// Jobs that wait for the disk. A full or damaged disk may be mended; waiting loses nothing, and
// nothing is deleted.
#include "common/core/host/log.hpp"
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

void Coordinator::wait_for_disk(MasterJob& job,
                                const Error& why,
                                std::function<void(MasterJob*)> again) {
    if (why.code != ErrorCode::Io) {
        end_job(job, JobState::Failed, why.detail);
        return again(nullptr);
    }
    job_paused(job, why.detail);
    if (!closed_) {
        retries_.start(job.id, [this, id = job.id, again = std::move(again)] {
            if (!closed_) {
                again(jobs_.find_running(id));
                feed();
            }
        });
    }
}

void Coordinator::disk_gives(MasterJob& job) {
    if (!retries_.any(job.id)) {
        job_paused(job, "");
    }
}

} // namespace cd
