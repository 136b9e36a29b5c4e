// Writes to the journal and announces what has become durable.
#pragma once

#include "master/journal/journal.hpp"
#include "master/journal/ledger.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// Owns the order between writing and announcing: a client or a worker hears of something only when
/// the journal has it. All members run on one thread.
class JournalWriter {
  public:
    /// Announcements, each after the journal has committed its cause.
    struct Events {
        /// Results that the worker may forget, by their sequence numbers.
        std::function<void(WorkerId worker, const ResultsKept& kept)> results_kept;
        std::function<void(JobId)> job_accepted;
        std::function<void(JobId)> job_ended;
        std::function<void(JobId)> job_dropped;
        std::function<void(const Dispute&)> dispute_opened;
        /// `paused` has changed.
        std::function<void()> paused;
        /// Entries were committed, so that there may be room for more.
        std::function<void()> committed;
    };

    /// Runs a function on the writer's thread; called on the journal's.
    using Post = std::function<void(std::function<void()>)>;

    /// The journal is not started yet. It must stop before the writer's thread, and after the
    /// writer.
    JournalWriter(Post post, Journal& journal) : post_(std::move(post)), journal_(journal) {}

    /// Notes the results that a recovered job has in the journal, before `start`.
    void restore(JobId job, std::span<const ResultRow> results);
    /// Starts the journal. Call once, before any `write`.
    void start(Events events);

    /// Writes an entry. Announces an accepted, ended or dropped job when it is durable.
    void write(JournalEntry entry);
    /// Announces the dispute, or acknowledges the results, when all entries written so far are
    /// durable.
    void promise(const Promise& promise) { ledger_.promise(promise, written_); }
    /// Acknowledges the results of a job when these scenarios are durable. Ignores scenarios
    /// without a result.
    void promise(const Delivery& delivery, JobId job, std::span<const std::uint64_t> scenarios) {
        ledger_.promise(delivery, job, scenarios);
    }
    /// Announces what is durable already; otherwise the next commit does.
    void announce();
    /// Acknowledges nothing more to the worker.
    void forget(WorkerId worker) { ledger_.forget(worker); }

    /// Why the journal does not write; empty if it does.
    [[nodiscard]] const std::string& paused() const { return paused_; }
    /// The journal writes, and its queue has room for more results.
    [[nodiscard]] bool has_room() const { return paused_.empty() && !is_full(); }
    /// Calls `done` now, or when the queue has room.
    void when_room(std::function<void()> done);

    /// Aborts when an invariant is broken; for tests, after each event.
    void check_invariants() const { ledger_.check_invariants(); }

  private:
    [[nodiscard]] bool is_full() const;
    void committed(std::uint64_t position);

    Post post_;
    Journal& journal_;
    Events events_;
    Ledger ledger_;
    std::uint64_t written_ = 0; ///< Journal position of the last entry.
    std::string paused_;
    std::vector<std::function<void()>> waiting_for_room_;
};

} // namespace cd
