// Writes entries to the journal, and announces events once the journal has committed them.
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

/// Enforces that clients and workers learn of an event only after the journal has committed it. All
/// members run on one thread.
class JournalWriter {
  public:
    /// Callbacks. Each one with an argument is called after the commit of the event that it names.
    struct Events {
        /// The worker may forget the result messages whose sequence numbers are in `kept`.
        std::function<void(WorkerId worker, const ResultsKept& kept)> results_kept;
        std::function<void(JobId)> job_recorded; ///< Accepted, or its record has changed.
        std::function<void(JobId)> job_ended;
        std::function<void(JobId)> job_dropped;
        std::function<void(const Dispute&)> dispute_opened;
        /// The value of `JournalWriter::paused` has changed.
        std::function<void()> paused;
        /// Entries were committed, so that the queue may have room for more.
        std::function<void()> committed;
    };

    /// Runs a function on the writer's thread; called on the journal's thread.
    using Post = std::function<void(std::function<void()>)>;

    /// The journal must not be started yet. It must be destroyed after the writer, and before the
    /// writer's thread ends.
    JournalWriter(Post post, Journal& journal) : post_(std::move(post)), journal_(journal) {}

    /// Call before `start` for each recovered job that continues: its results are durable already.
    void restore(JobId job, std::span<const ResultRow> results);
    /// Starts the journal. Call once, before any `write`.
    void start(Events events);

    /// Writes an entry. Announces an accepted, changed, ended or dropped job when it is durable.
    /// Returns the entry's position.
    std::uint64_t write(JournalEntry entry);
    /// True if the entry at this position is durable.
    [[nodiscard]] bool is_durable(std::uint64_t position) const {
        return position <= ledger_.position();
    }
    /// Announces the dispute, or acknowledges the result message, once all entries written so far
    /// are durable.
    void promise(const Promise& promise) { ledger_.promise(promise, written_); }
    /// Acknowledges the result message once the results of these scenarios are durable. Ignores
    /// scenarios without a result.
    void promise(const Delivery& delivery, JobId job, std::span<const std::uint64_t> scenarios) {
        ledger_.promise(delivery, job, scenarios);
    }
    /// Announces all events that are durable already. Each commit announces events, too.
    void announce();
    /// Drops all pending acknowledgements to the worker.
    void forget(WorkerId worker) { ledger_.forget(worker); }

    /// What was handed to the journal since the master started.
    struct Counts {
        std::uint64_t results = 0; ///< Results of scenarios, including those withdrawn later.
        std::uint64_t bytes = 0;   ///< Bytes of their records.
    };
    [[nodiscard]] const Counts& counts() const { return counts_; }

    /// Error because of which the journal cannot write; empty if it can.
    [[nodiscard]] const std::string& paused() const { return paused_; }
    /// True if the journal can write and its queue has room for more results.
    [[nodiscard]] bool has_room() const { return paused_.empty() && !is_full(); }
    /// Calls `done` now, or as soon as the queue has room.
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
    Counts counts_;
    std::string paused_;
    std::vector<std::function<void()>> waiting_for_room_;
};

} // namespace cd
