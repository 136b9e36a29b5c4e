// The results of a running job with the author of each, so that the results of a wrong worker can
// be withdrawn.
#pragma once

#include "common/job/result/merge.hpp"
#include "master/base/instance_id.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

namespace cd {

/// Merges the results of a job and remembers who gave each. Memory: 12 bytes per scenario beside
/// the digest.
class MergedResults {
  public:
    using Outcome = ResultMerger::Outcome;

    explicit MergedResults(std::uint64_t scenarios) : merger_(scenarios) {}
    /// Continues with results from before a restart. Call `restore` for each of them, unless the
    /// job has ended; `contributors` are then the processes whose results count.
    explicit MergedResults(ResultMerger merged, std::set<InstanceId> contributors = {})
        : merger_(std::move(merged)), contributors_(std::move(contributors)) {}

    /// Notes facts and author of a result that the merger already counts.
    void restore(std::uint64_t scenario,
                 const ScenarioFacts& facts,
                 const std::shared_ptr<const Author>& author);
    /// The first result of a scenario counts; later ones are compared with it. `author` is null for
    /// the master.
    [[nodiscard]] Outcome add(std::uint64_t scenario,
                              const ScenarioFacts& facts,
                              const Sha256& digest,
                              const std::shared_ptr<const Author>& author);
    /// Removes all results of a process, as if they had never come. Returns their scenarios in
    /// ascending order.
    [[nodiscard]] std::vector<std::uint64_t> withdraw(InstanceId process);
    /// Removes the result of a scenario, which must have one.
    void withdraw_one(std::uint64_t scenario);

    [[nodiscard]] bool has(std::uint64_t scenario) const { return merger_.has(scenario); }
    /// The scenario must have a result.
    [[nodiscard]] const Sha256& digest_of(std::uint64_t scenario) const {
        return merger_.digest_of(scenario);
    }
    /// Null: the scenario has no result, or it is the master's, or its author is no longer known.
    [[nodiscard]] std::shared_ptr<const Author> author_of(std::uint64_t scenario) const;
    /// True if the master itself has failed the scenario, so that it must not be run again.
    [[nodiscard]] bool is_failed_by_master(std::uint64_t scenario) const;
    /// All processes whose results count; of an ended job, too.
    [[nodiscard]] std::set<InstanceId> processes() const;

    /// Marks the scenarios that have a result, by index. Null if none has.
    [[nodiscard]] std::shared_ptr<const std::vector<bool>> marks() const;
    [[nodiscard]] const Summary& summary() const { return merger_.summary(); }
    /// Digest of the job; empty until all scenarios are merged.
    [[nodiscard]] std::optional<Sha256> digest() const { return merger_.digest(); }
    /// Ends the merge: frees digests and facts, and keeps at most `limits::authors_kept_max`
    /// authors. Only `has`, `author_of`, `processes` and `summary` may be called afterwards.
    void close();

  private:
    /// `ScenarioFacts` in 8 bytes.
    struct PackedFacts {
        std::uint64_t pair_count : 56;
        std::uint64_t kind : 4;
        std::uint64_t surfaces_only : 1;
        std::uint64_t insides_skipped : 1;
        std::uint64_t is_cut : 1;
    };
    [[nodiscard]] static PackedFacts pack(const ScenarioFacts& facts);
    [[nodiscard]] static ScenarioFacts unpack(const PackedFacts& facts);
    [[nodiscard]] std::uint32_t number_of(const std::shared_ptr<const Author>& author);

    ResultMerger merger_;
    std::vector<PackedFacts> facts_;
    std::vector<std::uint32_t> author_numbers_; ///< By scenario: index in `authors_`; 0: none.
    std::vector<std::shared_ptr<const Author>> authors_{nullptr};
    std::unordered_map<const Author*, std::uint32_t> numbers_; ///< Of `authors_`.
    std::uint32_t number_last_ = 0;     ///< Of the last author: results come in messages of one.
    std::set<InstanceId> contributors_; ///< Once closed: the processes whose results count.
};

} // namespace cd
