// Durability: writes to the journal and acts on its commits.
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

JournalEvents Coordinator::journal_events() {
    return {[this, executor = parts_.executor](std::uint64_t position) {
                asio::post(executor, [this, position] { journal_committed(position); });
            },
            [this, executor = parts_.executor](const std::string& why) {
                asio::post(executor, [this, why] {
                    paused_ = why;
                    for (const JobId job : jobs_.running()) {
                        ++jobs_.find(job)->changes;
                    }
                    feed();
                });
            }};
}

std::uint64_t Coordinator::write(JournalEntry entry) {
    written_ = parts_.journal.add(std::move(entry));
    return written_;
}

bool Coordinator::journal_has_room() const {
    return paused_.empty() && parts_.journal.queued_bytes() < limits::journal_queue_bytes_max;
}

void Coordinator::journal_committed(std::uint64_t position) {
    ledger_.committed(position);
    keep_promises();
    if (parts_.journal.queued_bytes() < limits::journal_queue_bytes_max) {
        for (const auto& done : std::exchange(waiting_for_room_, {})) {
            done();
        }
    }
    feed();
}

void Coordinator::go_on(std::function<void()> done) {
    if (parts_.journal.queued_bytes() < limits::journal_queue_bytes_max) {
        done();
    } else {
        waiting_for_room_.push_back(std::move(done));
    }
}

void Coordinator::keep_promises() {
    std::map<WorkerId, ResultsKept> kept;
    for (const Promise& promise : ledger_.take_kept()) {
        if (const auto* delivery = std::get_if<Delivery>(&promise)) {
            kept[delivery->worker].sequences.push_back(delivery->sequence);
        } else if (const auto* accepted = std::get_if<JobAccepted>(&promise)) {
            waiting_for_acceptance_.at(accepted->job)->cancel();
            waiting_for_acceptance_.erase(accepted->job);
        } else if (const auto* ended = std::get_if<JobEnded>(&promise)) {
            job_ended(ended->job);
        } else if (const auto* dispute = std::get_if<Dispute>(&promise)) {
            run_disputed(*dispute);
        } else {
            const JobId dropped = std::get<JobDropped>(promise).job;
            for (const auto& path : parts_.journal.files_of(dropped)) {
                parts_.blocking.post([path] { remove_file(path); });
            }
            wake_waiting(dropped);
        }
    }
    for (const auto& [worker, message] : kept) {
        if (const auto link = workers_.find(worker); link != workers_.end()) {
            link->second.channel->send(message);
        }
    }
}

void Coordinator::job_ended(JobId id) {
    ledger_.close_job(id);
    MasterJob* job = jobs_.find(id);
    CD_CHECK(job != nullptr);
    job->results->close();
    for (const JobId dropped : jobs_.announce(*job)) {
        drop_from_journal(dropped);
    }
    const JobStatus status = status_of(*job);
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
    wake_waiting(id);
    look_at_late_results(id);
}

void Coordinator::wake_waiting(JobId job) {
    const auto [begin, end] = waiting_for_end_.equal_range(job);
    for (auto waiting = begin; waiting != end; ++waiting) {
        if (const auto timer = waiting->second.lock()) {
            timer->cancel();
        }
    }
    waiting_for_end_.erase(begin, end);
}

void Coordinator::drop_from_journal(JobId job) {
    ledger_.promise(JobDropped{job}, write(DropJob{job}));
}

JobStatus Coordinator::status_of(const MasterJob& job) const {
    JobStatus status = job.status(Clock::now());
    add_what_it_waits_for(status);
    return status;
}

} // namespace cd
