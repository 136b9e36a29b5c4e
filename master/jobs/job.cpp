#include "master/jobs/job.hpp"

#include "common/core/check.hpp"
#include "common/core/host/wall_clock.hpp"
#include "master/submission/submission.hpp"

#include <utility>

namespace cd {

MasterJob::MasterJob(JobId job,
                     Submit submission,
                     std::shared_ptr<ResultStore> store,
                     Clock::time_point now)
    : id(job),
      submit(std::move(submission)),
      times{0, now, 0, now},
      merged(submit.scenarios, submit.scene_head()),
      results(std::move(store)),
      run(std::in_place) {}

MasterJob::MasterJob(RecoveredJob&& recovered, Clock::time_point now)
    : id(recovered.record.id),
      submit(std::move(recovered.record.submit)),
      times{recovered.record.began, now, recovered.progress.seconds, now},
      merged(std::move(recovered.merger),
             recovered.end ? std::move(recovered.contributors) : std::set<InstanceId>()),
      results(std::move(recovered.results)),
      map(std::move(recovered.map)),
      tally{recovered.progress.answered_by_master,
            recovered.withdrawn,
            recovered.progress.statistics,
            recovered.progress.compute_seconds,
            recovered.progress.traffic,
            recovered.progress.help,
            std::move(recovered.progress.depths)},
      end(std::move(recovered.end)),
      is_announced(end.has_value()) {
    if (end) {
        drop_bulk(submit);
    } else {
        run.emplace();
        run->losses_before = std::move(recovered.losses);
    }
}

void MasterJob::finish(JobState state, const std::string& failure, Clock::time_point now) {
    CD_CHECK(is_running());
    CD_CHECK(state != JobState::Running);
    times.ended = now;
    end = JobEnd{state, failure, {}, unix_seconds()};
    if (state == JobState::Done) {
        end->digest = merged.digest();
        CD_CHECK(end->digest.has_value());
    }
    merged.close();
    map.finish();
    run.reset();
    drop_bulk(submit);
}

JobProgress MasterJob::progress(Clock::time_point now) const {
    const std::chrono::duration<double> running =
        (is_running() ? now : times.ended) - times.started;
    return {times.seconds_before + running.count(),
            tally.answered_by_master,
            tally.statistics,
            tally.compute_seconds,
            tally.traffic,
            tally.help,
            tally.depths,
            map.withdrawn()};
}

JobStatus MasterJob::status(Clock::time_point now) const {
    JobStatus status;
    status.job = id;
    status.name = submit.name;
    status.state = state();
    status.summary = merged.summary();
    status.seconds = progress(now).seconds;
    if (status.seconds > 0) {
        status.scenarios_per_second = static_cast<double>(status.summary.merged()) / status.seconds;
    }
    if (is_announced) {
        status.digest = end->digest;
        status.failure = end->failure;
    }
    for (const JobBody& body : submit.bodies) {
        status.bodies.push_back(body.mesh);
    }
    if (run) {
        status.paused = run->paused;
    }
    status.answered_by_master = tally.answered_by_master;
    status.statistics = tally.statistics;
    status.compute_seconds = tally.compute_seconds;
    status.withdrawn = tally.withdrawn;
    status.recalled = tally.help.recalled;
    status.copies = tally.help.copies;
    status.copies_won = tally.help.copies_won;
    status.traffic = tally.traffic;
    status.depths = tally.depths;
    status.turn = {submit.owner, submit.priority, 0};
    status.began = times.began;
    return status;
}

} // namespace cd
