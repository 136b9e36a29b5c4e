// Gathers a job's results, each scenario once, and makes the job's digest and summary.
#pragma once

#include "common/job/result/result.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace cd {

/// Coverage and classes of a job so far (USERS, section 5).
struct Summary {
    std::uint64_t total = 0;
    std::uint64_t separate = 0;
    std::uint64_t touch = 0;
    std::uint64_t cross = 0;
    std::uint64_t inside = 0;
    std::uint64_t contact = 0; ///< Level any only.
    std::uint64_t undecided = 0;
    std::uint64_t failed = 0;
    std::uint64_t pairs = 0;           ///< The true number over all scenarios.
    std::uint64_t surfaces_only = 0;   ///< Scenarios with an open body.
    std::uint64_t insides_skipped = 0; ///< Scenarios with parts of which no insides are told.
    std::uint64_t cut = 0;             ///< Scenarios whose list of pairs is cut.

    [[nodiscard]] std::uint64_t merged() const {
        return separate + touch + cross + inside + contact + undecided + failed;
    }
    /// Answered: merged and not failed.
    [[nodiscard]] std::uint64_t tested() const { return merged() - failed; }
    [[nodiscard]] bool is_complete() const { return merged() == total; }
};

/// What a summary counts of a result.
struct ScenarioFacts {
    ScenarioClass kind = ScenarioClass::Separate;
    bool surfaces_only = false;
    bool insides_skipped = false;
    bool is_cut = false;
    std::uint64_t pair_count = 0;

    friend bool operator==(const ScenarioFacts&, const ScenarioFacts&) = default;
};
[[nodiscard]] ScenarioFacts facts_of(const ScenarioResult& result);

/// The merge is idempotent by scenario: of several results for one, the first counts and later ones
/// are compared with it. Memory: a hash for each scenario up to the last that came.
class ResultMerger {
  public:
    explicit ResultMerger(std::uint64_t scenarios);

    enum class Outcome : std::uint8_t {
        Added,    ///< The first result of this scenario.
        Repeated, ///< Equal to the one already merged.
        Differs,  ///< Not equal: a fault of memory or code. The first one stays.
        Foreign,  ///< No such scenario.
    };

    [[nodiscard]] Outcome add(const ScenarioResult& result);
    /// The same for a result whose record is at hand: `digest` is the record's SHA-256.
    [[nodiscard]] Outcome add(const ScenarioResult& result, const Sha256& digest);
    /// The same for a result of which only this is known any more.
    [[nodiscard]] Outcome
    add(std::uint64_t index, const ScenarioFacts& facts, const Sha256& digest);
    /// Removes a merged result, which has these facts.
    void remove(std::uint64_t index, const ScenarioFacts& facts);
    [[nodiscard]] bool has(std::uint64_t index) const;
    /// Of a result that is here.
    [[nodiscard]] const Sha256& digest_of(std::uint64_t index) const;

    [[nodiscard]] const Summary& summary() const { return summary_; }

    /// SHA-256 over the scenarios' digests in submitted order; nothing until all are merged.
    [[nodiscard]] std::optional<Sha256> digest() const;

    /// Gives back the memory of the hashes. What needs them is over: `add`, `remove`, `digest_of`
    /// and `digest`.
    void close();

  private:
    [[nodiscard]] bool is_open() const { return digests_.size() == merged_.size(); }
    [[nodiscard]] std::uint64_t& count_of(ScenarioClass kind);
    void count(const ScenarioFacts& facts);

    // Both grow with the scenarios that came, so that a job's claimed size costs nothing.
    std::vector<Sha256> digests_;
    std::vector<bool> merged_;
    Summary summary_;
};

} // namespace cd
