// Picks the worker for a scenario (paper, section 6.5 and the strategies of section 7).
#pragma once

#include "common/core/id.hpp"
#include "common/tree/root_holders.hpp"
#include "proto/messages/cluster_options.hpp"

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace cd {

/// Roots of both trees that a scenario touches, ascending, each with its triangle count.
struct ScenarioRoots {
    std::vector<WeightedRoot> a;
    std::vector<WeightedRoot> b;
};

/// A worker that may get the scenario.
struct WorkerCandidate {
    WorkerId worker;
    /// The paper's score: the sum over both trees of scenario indicator x (held ? 1 : 0), which is
    /// the number of triangles that the worker already holds.
    std::uint64_t held_triangles = 0;
    double load = 0;             ///< Buffered scenarios / q, below 1.
    std::uint64_t scenarios = 0; ///< Buffered, or at the worker and unanswered.
};

/// Implements the strategies of the paper's section 7. `best-match` takes the highest score,
/// `best-match-load` the highest score x (1 - load), `lowest` the lowest score, and `random` any
/// worker, drawn from a generator with the given seed. Deterministic: ties go to the worker with
/// the fewest scenarios, then to the smallest id. Pull strategies and matching by time use no
/// matchmaker.
class Matchmaker {
  public:
    Matchmaker(Strategy strategy, std::uint64_t seed);

    /// False if only the number of candidates matters.
    [[nodiscard]] bool looks_at_scores() const { return strategy_ != Strategy::Random; }

    /// Empty if there is no candidate. Candidates must ascend by id.
    [[nodiscard]] std::optional<WorkerId> choose(std::span<const WorkerCandidate> candidates);

    /// For a free worker (paper, 5.1): the indices of the `count` highest scores, ascending. Ties
    /// go to the smaller index.
    [[nodiscard]] static std::vector<std::size_t>
    most_similar(std::span<const std::uint64_t> scores, std::size_t count);

  private:
    Strategy strategy_;
    std::mt19937_64 random_;
};

} // namespace cd
