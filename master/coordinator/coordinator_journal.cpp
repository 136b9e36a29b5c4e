// Acts on what the journal has committed.
#include "common/core/check.hpp"
#include "common/core/host/log.hpp"
#include "common/core/limits/master.hpp"
#include "master/coordinator/coordinator.hpp"

namespace cd {

namespace {

void remove_file(const std::filesystem::path& path) {
    std::error_code ignored; // A leftover file does no harm.
    std::filesystem::remove(path, ignored);
}

} // namespace

JournalWriter::Events Coordinator::journal_events() {
    return {[this](WorkerId worker, const ResultsKept& kept) {
                if (const Worker* here = workers_.find(worker)) {
                    here->channel->send(kept);
                }
            },
            [this](JobId job) { waits_.wake(job); },
            [this](JobId job) { job_ended(job); },
            [this](JobId job) { job_dropped(job); },
            [this](const Dispute& dispute) { run_disputed(dispute); },
            [this] {
                for (const JobId job : jobs_.running()) {
                    ++jobs_.find(job)->changes;
                }
                feed();
            },
            [this] { feed(); }};
}

void Coordinator::job_dropped(JobId job) {
    for (const auto& path : parts_.journal.files_of(job)) {
        parts_.blocking.post([path] { remove_file(path); });
    }
    waits_.wake(job);
}

void Coordinator::job_ended(JobId id) {
    MasterJob* job = jobs_.find(id);
    CD_CHECK(job != nullptr);
    job->results->close();
    for (const JobId dropped : jobs_.announce(*job)) {
        drop_from_journal(dropped);
    }
    const JobStatus status = job_status(id).value();
    log_info("job ended: job={} state={} merged={} total={} seconds={:.3f} recalled={} copies={} "
             "copies_won={} digest={}{}",
             id.value,
             to_text(status.state),
             status.summary.merged(),
             status.summary.total,
             status.seconds,
             status.recalled,
             status.copies,
             status.copies_won,
             status.digest ? to_short_hex(*status.digest) : "none",
             status.failure.empty() ? "" : " reason=\"" + status.failure + "\"");
    waits_.wake(id);
    look_at_late_results(id);
}

void Coordinator::drop_from_journal(JobId job) {
    writer_.write(DropJob{job});
}

} // namespace cd
