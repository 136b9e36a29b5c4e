// Merges a job's results, each scenario once, and computes the job's digest and summary.
#pragma once

#include "common/core/growing_list.hpp"
#include "common/job/result/result.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace cd {

/// Numbers of merged scenarios of a job, by class (docs/formats.md).
struct ClassCounts {
    std::uint64_t separate = 0;
    std::uint64_t touch = 0;
    std::uint64_t cross = 0;
    std::uint64_t inside = 0;
    std::uint64_t contact = 0; ///< At `level any` only.
    std::uint64_t undecided = 0;
    std::uint64_t failed = 0;
    std::uint64_t near = 0; ///< With a clearance only.
};

/// What is known of a job's merged scenarios.
struct Summary : ClassCounts {
    std::uint64_t total = 0;           ///< Scenarios of the job, merged or not.
    std::uint64_t pairs = 0;           ///< Pairs in contact, including those that a limit cut off.
    std::uint64_t near_pairs = 0;      ///< Pairs of class Near, likewise.
    std::uint64_t surfaces_only = 0;   ///< Scenarios with an open body.
    std::uint64_t insides_skipped = 0; ///< Scenarios with parts whose containment is not decided.
    std::uint64_t cut = 0;             ///< Scenarios whose list of pairs is cut off.

    [[nodiscard]] std::uint64_t merged() const {
        return separate + touch + cross + inside + contact + undecided + failed + near;
    }
    /// Scenarios that are merged and not failed.
    [[nodiscard]] std::uint64_t tested() const { return merged() - failed; }
    [[nodiscard]] bool is_complete() const { return merged() == total; }
};

/// The properties of a result that a summary counts.
struct ScenarioFacts {
    ScenarioClass kind = ScenarioClass::Separate;
    bool surfaces_only = false;
    bool insides_skipped = false;
    bool is_cut = false;
    bool has_distance = false; ///< With Question::Distance: there is a distance.
    std::uint64_t pair_count = 0;
    std::uint64_t near_count = 0;

    /// Whether the result says more than that the bodies are separate.
    [[nodiscard]] bool tells() const { return kind != ScenarioClass::Separate || has_distance; }

    friend bool operator==(const ScenarioFacts&, const ScenarioFacts&) = default;
};
[[nodiscard]] ScenarioFacts facts_of(const ScenarioResult& result);

/// Starts the digest of a scene of many bodies (docs/formats.md): a hash of all that decides which
/// pairs of bodies each step tests.
struct SceneHead {
    Sha256 hash;

    friend bool operator==(const SceneHead&, const SceneHead&) = default;
};

/// Merges results idempotently: the first result of a scenario counts, and later results are
/// compared with the first. Memory: one hash for each scenario up to the highest one merged, and
/// for at most 1,023 more.
class ResultMerger {
  public:
    /// With `scene`, the digest is that of a scene.
    explicit ResultMerger(std::uint64_t scenarios, std::optional<SceneHead> scene = std::nullopt);

    enum class Outcome : std::uint8_t {
        Added,    ///< The first result of this scenario.
        Repeated, ///< Equal to the result already merged.
        Differs,  ///< Unequal to the merged result, which stays: a fault of memory or code.
        Foreign,  ///< The job has no such scenario.
    };

    [[nodiscard]] Outcome add(const ScenarioResult& result);
    /// Adds a result whose record has the SHA-256 `digest`.
    [[nodiscard]] Outcome add(const ScenarioResult& result, const Sha256& digest);
    /// Adds a result of which only index, facts and digest are known.
    [[nodiscard]] Outcome
    add(std::uint64_t index, const ScenarioFacts& facts, const Sha256& digest);
    /// Removes a merged result. `facts` must equal those with which it was added.
    void remove(std::uint64_t index, const ScenarioFacts& facts);
    [[nodiscard]] bool has(std::uint64_t index) const { return index < places() && merged_[index]; }
    /// The number of scenarios, counted from the first one, for which memory is reserved.
    [[nodiscard]] std::uint64_t places() const { return merged_.size(); }
    /// Returns the digest of a merged result.
    [[nodiscard]] const Sha256& digest_of(std::uint64_t index) const;

    [[nodiscard]] const Summary& summary() const { return summary_; }

    /// Returns SHA-256 over the scenarios' digests in submitted order, or nothing until all are
    /// merged. The digest of a scene is over its head and the digests of the results that tell
    /// something (`ScenarioFacts::tells`), so that it does not depend on the broad phase.
    [[nodiscard]] std::optional<Sha256> digest() const;

    /// Frees the memory of the hashes. Afterwards `add`, `remove`, `digest_of` and `digest` may not
    /// be called.
    void close();

  private:
    [[nodiscard]] bool is_open() const { return digests_.size() == merged_.size(); }
    [[nodiscard]] std::uint64_t& count_of(ScenarioClass kind);
    void count(const ScenarioFacts& facts);

    /// Reserves memory for the scenario and for at most 1,023 after it.
    void grow_to(std::uint64_t index);

    // The lists are as long as the highest merged index requires. A client may announce a huge job,
    // which must not take memory before it has results.
    GrowingList<Sha256> digests_;
    std::vector<bool> merged_;
    std::vector<bool> tell_; ///< Of a scene: whether the result tells something.
    std::optional<SceneHead> scene_;
    Summary summary_;
};

} // namespace cd
