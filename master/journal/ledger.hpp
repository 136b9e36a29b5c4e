// Tracks which results are durable and may be acknowledged: a state machine without files, clocks
// or threads.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/id.hpp"
#include "master/base/instance_id.hpp"

#include <array>
#include <bitset>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <span>
#include <unordered_map>
#include <variant>
#include <vector>

namespace cd {

/// A message of results, as numbered by its worker.
struct Delivery {
    WorkerId worker;
    std::uint64_t sequence = 0;

    friend auto operator<=>(const Delivery&, const Delivery&) = default;
};
/// The job is in the journal: its client may be told.
struct JobAccepted {
    JobId job;

    friend bool operator==(const JobAccepted&, const JobAccepted&) = default;
};
/// The job's end is in the journal, after all of its results.
struct JobEnded {
    JobId job;

    friend bool operator==(const JobEnded&, const JobEnded&) = default;
};
/// The journal has forgotten the job: its files may be deleted.
struct JobDropped {
    JobId job;

    friend bool operator==(const JobDropped&, const JobDropped&) = default;
};
/// Two results of a scenario differ, and both are in the journal: they may be judged.
struct Dispute {
    JobId job;
    std::uint64_t scenario = 0;
    std::shared_ptr<const Author>
        second;    ///< Author of the result that differs from the merged one.
    Sha256 digest; ///< Digest of the differing result.

    friend bool operator==(const Dispute&, const Dispute&) = default;
};

/// An event that is announced once the journal has committed it.
using Promise = std::variant<Delivery, JobAccepted, JobEnded, JobDropped, Dispute>;

/// The journal writes and commits its entries in the order of their positions, from 1. Every
/// scenario of an open job is unknown, written (in an uncommitted entry), or durable.
class Ledger {
  public:
    enum class State : std::uint8_t { Unknown, Written, Durable };

    void open_job(JobId job);
    /// Forgets the job's results, also uncommitted ones.
    void close_job(JobId job);

    /// Marks a scenario of an open job as durable since an earlier incarnation of the master.
    void restore(JobId job, std::uint64_t scenario);
    /// Records that the scenario's result is in the entry at `position`, which never decreases. The
    /// job must be open and the scenario unknown.
    void write(JobId job, std::uint64_t scenario, std::uint64_t position);
    /// Forgets results of an open job that were withdrawn. They must be written or durable.
    void withdraw(JobId job, std::span<const std::uint64_t> scenarios);

    /// Keeps the promise once all entries up to this position are committed.
    void promise(const Promise& promise, std::uint64_t position);
    /// Keeps the promise once these scenarios are durable. Ignores unknown scenarios and those of
    /// jobs that are not open.
    void promise(const Delivery& delivery, JobId job, std::span<const std::uint64_t> scenarios);
    /// Drops all promises to the worker.
    void forget(WorkerId worker);

    /// All entries up to this position are on disk.
    void committed(std::uint64_t position);
    /// Returns the promises kept since the last call, in the order of the entries.
    [[nodiscard]] std::vector<Promise> take_kept();

    [[nodiscard]] State state(JobId job, std::uint64_t scenario) const;
    [[nodiscard]] std::uint64_t
    durable(JobId job) const; ///< Number of durable scenarios; 0 if the job is not open.
    [[nodiscard]] std::uint64_t position() const { return committed_; }
    [[nodiscard]] std::size_t owed() const { return promises_.size(); }

    /// Aborts when an invariant is broken; for tests, after each event.
    void check_invariants() const;

  private:
    static constexpr std::uint64_t block_scenarios = 4096;
    /// Scenario states in bitmaps, made on demand: a client chooses the number of scenarios.
    struct Block {
        std::bitset<block_scenarios> written; ///< Includes durable scenarios.
        std::bitset<block_scenarios> durable;
    };
    struct Job {
        std::unordered_map<std::uint64_t, std::unique_ptr<Block>> blocks;
        std::uint64_t durable = 0;
    };
    struct Entry {
        std::uint64_t position = 0;
        JobId job;
        std::uint64_t scenario = 0;
    };

    [[nodiscard]] static Block& block_of(Job& job, std::uint64_t scenario);

    std::unordered_map<JobId, Job> jobs_;
    std::deque<Entry> entries_; ///< Written and uncommitted entries, by position.
    std::multimap<std::uint64_t, Promise> promises_; ///< Promises, by the position they wait for.
    std::vector<Promise> kept_;
    std::uint64_t committed_ = 0;
};

} // namespace cd
