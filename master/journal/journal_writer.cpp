#include "master/journal/journal_writer.hpp"

#include "common/core/limits/master.hpp"

#include <map>
#include <optional>
#include <utility>
#include <variant>

namespace cd {

void JournalWriter::restore(JobId job, std::span<const ResultRow> results) {
    ledger_.open_job(job);
    for (const ResultRow& row : results) {
        ledger_.restore(job, row.scenario);
    }
}

void JournalWriter::start(Events events) {
    events_ = std::move(events);
    // The journal may still commit after the writer is destroyed. The functions that it posts then
    // never run, because the executor has stopped.
    journal_.start({[this, post = post_](std::uint64_t position) {
                        post([this, position] { committed(position); });
                    },
                    [this, post = post_](const std::string& why) {
                        post([this, why] {
                            paused_ = why;
                            events_.paused();
                        });
                    }});
}

std::uint64_t JournalWriter::write(JournalEntry entry) {
    const std::uint64_t position = written_ + 1;
    std::optional<Promise> promise;
    if (const auto* add = std::get_if<AddResults>(&entry)) {
        ledger_.withdraw(add->job, add->withdrawn);
        const std::span<const ResultRow> rows = add->results.rows();
        for (std::size_t i = 0; i < rows.size();) { // Runs of consecutive scenarios.
            const std::uint64_t first = rows[i].scenario;
            std::uint64_t count = 0;
            for (; i < rows.size() && rows[i].scenario == first + count; ++i) {
                ++count;
            }
            ledger_.write(add->job, first, position, count);
        }
        counts_.bytes += add->results.record_bytes();
        counts_.results += add->results.size();
    } else if (const auto* accept = std::get_if<AcceptJob>(&entry)) {
        ledger_.open_job(accept->job.id);
        promise = JobAccepted{accept->job.id};
    } else if (const auto* change = std::get_if<ChangeJob>(&entry)) {
        promise = JobChanged{change->job.id};
    } else if (const auto* end = std::get_if<EndJob>(&entry)) {
        promise = JobEnded{end->job};
    } else {
        promise = JobDropped{std::get<DropJob>(entry).job};
    }
    written_ = journal_.add(std::move(entry));
    if (promise) {
        ledger_.promise(*promise, written_);
    }
    return written_;
}

void JournalWriter::announce() {
    std::map<WorkerId, ResultsKept> kept;
    for (const Promise& promise : ledger_.take_kept()) {
        if (const auto* delivery = std::get_if<Delivery>(&promise)) {
            kept[delivery->worker].sequences.push_back(delivery->sequence);
        } else if (const auto* accepted = std::get_if<JobAccepted>(&promise)) {
            events_.job_recorded(accepted->job);
        } else if (const auto* changed = std::get_if<JobChanged>(&promise)) {
            events_.job_recorded(changed->job);
        } else if (const auto* ended = std::get_if<JobEnded>(&promise)) {
            ledger_.close_job(ended->job);
            events_.job_ended(ended->job);
        } else if (const auto* dispute = std::get_if<Dispute>(&promise)) {
            events_.dispute_opened(*dispute);
        } else {
            events_.job_dropped(std::get<JobDropped>(promise).job);
        }
    }
    for (const auto& [worker, message] : kept) {
        events_.results_kept(worker, message);
    }
}

void JournalWriter::when_room(std::function<void()> done) {
    if (is_full()) {
        waiting_for_room_.push_back(std::move(done));
    } else {
        done();
    }
}

bool JournalWriter::is_full() const {
    return journal_.queued_bytes() >= limits::journal_queue_bytes_max;
}

void JournalWriter::committed(std::uint64_t position) {
    ledger_.committed(position);
    announce();
    if (!is_full()) {
        for (const auto& done : std::exchange(waiting_for_room_, {})) {
            done();
        }
    }
    events_.committed();
}

} // namespace cd
