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

/// A result message, which the master acknowledges to the worker once the results are durable.
struct Delivery {
    WorkerId worker;
    std::uint64_t sequence = 0; ///< Number that the worker gave the message.

    friend auto operator<=>(const Delivery&, const Delivery&) = default;
};
/// Event: the journal has the job, so that its client may learn that it is accepted.
struct JobAccepted {
    JobId job;

    friend bool operator==(const JobAccepted&, const JobAccepted&) = default;
};
/// Event: the journal has a change of the job's record.
struct JobChanged {
    JobId job;

    friend bool operator==(const JobChanged&, const JobChanged&) = default;
};
/// Event: the journal has all results of the job, and then its end.
struct JobEnded {
    JobId job;

    friend bool operator==(const JobEnded&, const JobEnded&) = default;
};
/// Event: the journal has deleted the job, so that its files may be deleted.
struct JobDropped {
    JobId job;

    friend bool operator==(const JobDropped&, const JobDropped&) = default;
};
/// Event: two results of a scenario differ. Once the journal has it, the dispute may be decided.
struct Dispute {
    JobId job;
    std::uint64_t scenario = 0;
    std::shared_ptr<const Author> second; ///< Author of the later result, which was not merged.
    Sha256 digest;                        ///< Digest of the later result.

    friend bool operator==(const Dispute&, const Dispute&) = default;
};

/// An event that is announced once the journal has committed it.
using Promise = std::variant<Delivery, JobAccepted, JobChanged, JobEnded, JobDropped, Dispute>;

/// The journal commits its entries in the order of their positions, from 1. Every scenario of an
/// open job is unknown (without a result), written (in an uncommitted entry), or durable.
class Ledger {
  public:
    enum class State : std::uint8_t { Unknown, Written, Durable };

    void open_job(JobId job);
    /// Forgets the states of the job's scenarios, also of uncommitted ones.
    void close_job(JobId job);

    /// Marks a scenario of an open job as durable: a previous process of the master committed its
    /// result.
    void restore(JobId job, std::uint64_t scenario);
    /// Records that the results of `count` consecutive scenarios are in the entry at `position`.
    /// Positions must not decrease from call to call. The job must be open and the scenarios
    /// unknown.
    void write(JobId job, std::uint64_t first, std::uint64_t position, std::uint64_t count = 1);
    /// Marks scenarios as unknown because their results were withdrawn. The job must be open, and
    /// each scenario written or durable.
    void withdraw(JobId job, std::span<const std::uint64_t> scenarios);

    /// Makes `take_kept` return the promise once all entries up to this position are committed.
    void promise(const Promise& promise, std::uint64_t position);
    /// Makes `take_kept` return the delivery once these scenarios are durable. Ignores unknown
    /// scenarios, and all scenarios if the job is not open.
    void promise(const Delivery& delivery, JobId job, std::span<const std::uint64_t> scenarios);
    /// Drops all promises to the worker.
    void forget(WorkerId worker);

    /// Reports that all entries up to this position are committed.
    void committed(std::uint64_t position);
    /// Returns the promises fulfilled since the last call, in the order of their entries.
    [[nodiscard]] std::vector<Promise> take_kept();

    [[nodiscard]] State state(JobId job, std::uint64_t scenario) const;
    /// Number of durable scenarios; 0 if the job is not open.
    [[nodiscard]] std::uint64_t durable(JobId job) const;
    /// Position of the last committed entry; 0 before the first.
    [[nodiscard]] std::uint64_t position() const { return committed_; }
    /// Number of promises that wait for a commit.
    [[nodiscard]] std::size_t owed() const { return promises_.size(); }

    /// Aborts when an invariant is broken; for tests, after each event.
    void check_invariants() const;

  private:
    static constexpr std::uint64_t block_scenarios = 4096;
    /// States of consecutive scenarios as bitmaps. Made on demand, because a client could announce
    /// a huge number of scenarios.
    struct Block {
        std::bitset<block_scenarios> written; ///< Includes durable scenarios.
        std::bitset<block_scenarios> durable;
    };
    struct Job {
        std::unordered_map<std::uint64_t, std::unique_ptr<Block>> blocks;
        std::uint64_t durable = 0;
    };
    /// Consecutive scenarios.
    struct Entry {
        std::uint64_t position = 0;
        JobId job;
        std::uint64_t first = 0;
        std::uint64_t count = 0;

        [[nodiscard]] std::uint64_t end() const { return first + count; }
    };

    [[nodiscard]] static Block& block_of(Job& job, std::uint64_t scenario);
    /// Calls `take(block, bit)` for the scenarios [first, end).
    template <class Take>
    static void for_each_bit(Job& job, std::uint64_t first, std::uint64_t end, const Take& take);

    std::unordered_map<JobId, Job> jobs_;
    std::deque<Entry> entries_; ///< Written and uncommitted scenarios, by position.
    /// Pending promises, by the position up to which entries must be committed first.
    std::multimap<std::uint64_t, Promise> promises_;
    std::vector<Promise> kept_;
    std::uint64_t committed_ = 0;
};

} // namespace cd
