#include "master/verify/quarantine.hpp"

#include "common/core/host/log.hpp"
#include "master/base/mutation.hpp"

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cd {

void withdraw_map(MasterJob& job, const std::string& why) {
    if (sums_contacts(job.submit)) {
        job.map.withdraw(why);
    }
}

void Quarantine::impose(const Author& wrong) {
    if (!parts_.alarms.quarantine(wrong.process)) {
        return;
    }
    log_error("worker quarantined: worker={}", wrong.worker.value);
    warn_of_ended_jobs(wrong);
    for (const JobId job : std::set(parts_.jobs.running())) {
        withdraw_results(wrong, parts_.jobs.at(job));
    }
    // The process may have several sessions, because it may have left and rejoined.
    for (const WorkerId id : parts_.workers.quarantine(wrong.process)) {
        parts_.blocks.worker_left(id);
        parts_.tasks.take_all_back(id); // The process is alive, so the work is not lost with it.
        parts_.dispatch.act(parts_.dispatch->worker_lost(id));
    }
}

void Quarantine::warn_of_ended_jobs(const Author& wrong) {
    std::string ended;
    for (const auto& [id, job] : parts_.jobs.all()) {
        if (!job.is_running() && job.merged.processes().contains(wrong.process)) {
            ended += (ended.empty() ? "" : ", ") + std::to_string(id.value);
        }
    }
    if (!ended.empty()) {
        parts_.alarms.raise("jobs that have ended hold results of " + wrong.to_text() +
                            ", which was wrong elsewhere; check them with cdctl verify: " + ended);
    }
}

void Quarantine::withdraw_results(const Author& wrong, MasterJob& job) {
    if (mutated(Mutation::LiarKept)) {
        return;
    }
    std::vector<std::uint64_t> scenarios = job.merged.withdraw(wrong.process);
    if (scenarios.empty()) {
        return;
    }
    log_warning("results withdrawn: job={} scenarios={} worker={}",
                job.id.value,
                scenarios.size(),
                wrong.worker.value);
    job.tally.withdrawn += scenarios.size();
    ++job.changes;
    withdraw_map(job, "a worker that has contributed to it was wrong elsewhere");
    if (JobWork* work = job.work()) { // A job without work queues all missing scenarios later.
        work->done.reset();
        parts_.ranges.give_again(job, scenarios);
    }
    AddResults withdrawal{job.id, job.results, {}, {}, {}};
    withdrawal.remarks.push_back({Remark::Kind::Withdrawn, 0, {}, wrong.process});
    withdrawal.withdrawn = std::move(scenarios);
    withdrawal.progress = job.progress(parts_.jobs.now());
    // The entry includes the quarantine, so that no withdrawal is durable without it.
    withdrawal.alarms = parts_.alarms.take_changed();
    parts_.writer.write(std::move(withdrawal));
}

} // namespace cd
