#include "master/jobs/job_life.hpp"

#include "common/core/host/log.hpp"

#include <utility>
#include <vector>

namespace cd {

namespace {

/// Pauses the job for the reason `why`, or resumes it if `why` is empty.
void pause(MasterJob& job, const std::string& why) {
    std::string& paused = job.run->paused;
    if (why == paused) {
        return;
    }
    if (why.empty()) {
        log_info("job goes on: job={}", job.id.value);
    } else if (paused.empty()) {
        log_error("job paused, the disk fails: job={} error=\"{}\"", job.id.value, why);
    }
    paused = why;
    ++job.changes;
}

} // namespace

void JobLife::end(MasterJob& job, JobState state, const std::string& failure) {
    const std::vector<TreeId> trees =
        job.work() == nullptr ? std::vector<TreeId>() : job.work()->trees;
    parts_.retries.stop(job.id);
    events_.ending(job.id);
    parts_.jobs.end(job, state, failure, now());
    parts_.dispatch.act(parts_.dispatch->job_closed(job.id));
    for (auto& [id, worker] : parts_.workers.all()) {
        worker.send(worker.supply.remove_job(job.id));
    }
    for (const TreeId tree : trees) {
        release_tree(tree);
    }
    parts_.writer.write(EndJob{job.id, *job.end, job.progress(now())});
}

void JobLife::end_if_complete(MasterJob& job) {
    if (job.is_running() && job.run->disputes == 0 && job.merged.summary().is_complete()) {
        end(job, JobState::Done, "");
    }
}

void JobLife::release_tree(TreeId tree) {
    if (!parts_.trees.release(tree)) {
        return;
    }
    parts_.blocks.tree_removed(tree);
    for (auto& [id, worker] : parts_.workers.all()) {
        worker.meter.transfers().tree_removed(tree);
        worker.send(worker.supply.remove_tree(tree));
    }
}

void JobLife::wait_for_disk(MasterJob& job,
                            const Error& why,
                            std::function<void(MasterJob*)> again) {
    if (why.code != ErrorCode::Io) {
        end(job, JobState::Failed, why.detail);
        return again(nullptr);
    }
    pause(job, why.detail);
    parts_.retries.start(job.id, [this, id = job.id, again = std::move(again)] {
        again(parts_.jobs.find_running(id));
        events_.retried();
    });
}

void JobLife::disk_gives(MasterJob& job) {
    if (!is_waiting(job.id)) {
        pause(job, "");
    }
}

} // namespace cd
