// The merged results of a job with the author of each, so that the results of a wrong worker can be
// withdrawn.
#pragma once

#include "common/core/growing_list.hpp"
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

/// Merges the results of a job and keeps the author of each. Takes 12 bytes per scenario in
/// addition to the merger, and 8 more if a result has near pairs.
class MergedResults {
  public:
    using Outcome = ResultMerger::Outcome;

    /// With `scene`, the digest is that of a scene.
    explicit MergedResults(std::uint64_t scenarios, std::optional<SceneHead> scene = std::nullopt)
        : merger_(scenarios, scene) {}
    /// Continues with the results in `merged` after a restart. For a running job, call `restore`
    /// for each result. For an ended job, `contributors` are the processes whose results count.
    explicit MergedResults(ResultMerger merged, std::set<InstanceId> contributors = {})
        : merger_(std::move(merged)), contributors_(std::move(contributors)) {}

    /// Sets facts and author of a result that the merger already has.
    void restore(std::uint64_t scenario,
                 const ScenarioFacts& facts,
                 const std::shared_ptr<const Author>& author);
    /// Merges the first result of a scenario, and compares any later one with the first. `author`
    /// is null for the master.
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
    /// Null if the scenario has no result, or the master gave it, or its author is forgotten.
    [[nodiscard]] std::shared_ptr<const Author> author_of(std::uint64_t scenario) const;
    /// True if the scenario's result is a failure that the master gave. Such a scenario must not
    /// run again.
    [[nodiscard]] bool is_failed_by_master(std::uint64_t scenario) const;
    /// All worker processes whose results count, also after `close`.
    [[nodiscard]] std::set<InstanceId> processes() const;

    /// Returns whether each scenario has a result, by index; null if none has.
    [[nodiscard]] std::shared_ptr<const std::vector<bool>> marks() const;
    [[nodiscard]] const Summary& summary() const { return merger_.summary(); }
    /// Digest over all results; empty until every scenario has one.
    [[nodiscard]] std::optional<Sha256> digest() const { return merger_.digest(); }
    /// Ends the merge: frees digests and facts, and keeps the authors of only the first
    /// `limits::authors_kept_max` scenarios. Afterwards, only `has`, `author_of`, `processes` and
    /// `summary` may be called.
    void close();

  private:
    /// `ScenarioFacts` without the number of near pairs, in 8 bytes.
    struct PackedFacts {
        std::uint64_t pair_count : 56;
        std::uint64_t kind : 4;
        std::uint64_t surfaces_only : 1;
        std::uint64_t insides_skipped : 1;
        std::uint64_t is_cut : 1;
        std::uint64_t has_distance : 1;
    };
    [[nodiscard]] static PackedFacts pack(const ScenarioFacts& facts);
    /// Returns the facts of a merged scenario.
    [[nodiscard]] ScenarioFacts facts_of(std::uint64_t scenario) const;
    void set_near_count(std::uint64_t scenario, std::uint64_t count);
    [[nodiscard]] std::uint32_t number_of(const std::shared_ptr<const Author>& author);

    ResultMerger merger_;
    GrowingList<PackedFacts> facts_;
    GrowingList<std::uint64_t> near_counts_;    ///< Zeros behind the end.
    GrowingList<std::uint32_t> author_numbers_; ///< Per scenario, index in `authors_`; 0: none.
    std::vector<std::shared_ptr<const Author>> authors_{nullptr};
    std::unordered_map<const Author*, std::uint32_t> numbers_; ///< Author's index in `authors_`.
    std::uint32_t number_last_ = 0;     ///< Last author's index, mostly right for the next result.
    std::set<InstanceId> contributors_; ///< Processes whose results count, once the job has ended.
};

} // namespace cd
