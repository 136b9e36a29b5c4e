// What is durable, and what may therefore be acknowledged: a state machine without files, clocks or
// threads.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/id.hpp"

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

/// A message of results, as its worker numbered it.
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
/// How the job ended is in the journal, after all of its results.
struct JobEnded {
    JobId job;

    friend bool operator==(const JobEnded&, const JobEnded&) = default;
};
/// The journal has forgotten the job: its files may go.
struct JobDropped {
    JobId job;

    friend bool operator==(const JobDropped&, const JobDropped&) = default;
};
/// Two results of a scenario differ, and both are in the journal: they may be judged.
struct Dispute {
    JobId job;
    std::uint64_t scenario = 0;
    WorkerId second; ///< Who brought the result that differs from the one that was merged,
    Sha256 digest;   ///< and that one.

    friend bool operator==(const Dispute&, const Dispute&) = default;
};

/// What somebody waits for until the journal has it.
using Promise = std::variant<Delivery, JobAccepted, JobEnded, JobDropped, Dispute>;

/// The journal writes its entries in the order of their positions, from 1, and commits them in this
/// order. Every scenario of an open job is unknown, written (in an entry that is not committed), or
/// durable.
class Ledger {
  public:
    enum class State : std::uint8_t { Unknown, Written, Durable };

    void open_job(JobId job);
    /// Its results are of no interest any more, also those that are still to be committed.
    void close_job(JobId job);

    /// The scenario is durable since an earlier life. The job is open.
    void restore(JobId job, std::uint64_t scenario);
    /// The scenario's result stands in the entry of this position, which is not less than those
    /// before. The job is open and the scenario unknown.
    void write(JobId job, std::uint64_t scenario, std::uint64_t position);

    /// Kept as soon as all entries up to this position are committed.
    void promise(const Promise& promise, std::uint64_t position);
    /// Kept as soon as these scenarios are durable. Unknown ones, and those of a job that is not
    /// open, are not waited for: nobody wants them.
    void promise(const Delivery& delivery, JobId job, std::span<const std::uint64_t> scenarios);
    /// Nothing more is owed to it.
    void forget(WorkerId worker);

    /// All entries up to this one are on the disk.
    void committed(std::uint64_t position);
    /// What may be said since the last call, in the order of the entries.
    [[nodiscard]] std::vector<Promise> take_kept();

    [[nodiscard]] State state(JobId job, std::uint64_t scenario) const;
    [[nodiscard]] std::uint64_t durable(JobId job) const; ///< Scenarios; 0 for no open job.
    [[nodiscard]] std::uint64_t position() const { return committed_; }
    [[nodiscard]] std::size_t owed() const { return promises_.size(); }

    /// Aborts when an invariant is broken; for tests, after each event.
    void check_invariants() const;

  private:
    static constexpr std::uint64_t block_scenarios = 4096;
    /// States in bitmaps, made when first needed: the number of scenarios is a client's word.
    struct Block {
        std::bitset<block_scenarios> written; ///< Also what is durable.
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
    std::deque<Entry> entries_;                      ///< Written and not committed, by position.
    std::multimap<std::uint64_t, Promise> promises_; ///< By the position that they wait for.
    std::vector<Promise> kept_;
    std::uint64_t committed_ = 0;
};

} // namespace cd
