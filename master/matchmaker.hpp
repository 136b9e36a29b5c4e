// Picks the worker for a scenario (paper, section 6.5 and the strategies of section 7).
#pragma once

#include "common/tree/cut.hpp"
#include "proto/message.hpp"

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace cd {

/// The roots of both trees that a scenario touches, ascending, each with its triangles.
struct ScenarioRoots {
    struct Root {
        RootIndex root = 0;
        std::uint32_t triangles = 0;
    };
    std::vector<Root> a;
    std::vector<Root> b;
};

/// A worker that may get the scenario: what it holds of both trees, and its load.
struct WorkerCandidate {
    WorkerId worker;
    const RootIndicator* held_a = nullptr;
    const RootIndicator* held_b = nullptr;
    double load = 0;             ///< Buffered scenarios / q, below 1.
    std::uint64_t scenarios = 0; ///< Buffered, or at the worker and unanswered.
};

/// Scores and chooses, by the strategies of the paper's section 7:
/// `best-match` the highest score; `best-match-load` the highest score x (1 - load); `random` any,
/// drawn from a generator of the given seed; `lowest` the lowest score. Deterministic: equals go to
/// the worker with the fewest scenarios, then to the smallest id.
class Matchmaker {
  public:
    Matchmaker(Strategy strategy, std::uint64_t seed);

    /// The sum over both trees of scenario indicator x (held ? 1 : 0): the triangles that the
    /// worker has already.
    [[nodiscard]] static std::uint64_t score(const ScenarioRoots& scenario,
                                             const WorkerCandidate& candidate);

    /// Nothing when there is no candidate. Candidates come in ascending order of id.
    [[nodiscard]] std::optional<WorkerId> choose(const ScenarioRoots& scenario,
                                                 std::span<const WorkerCandidate> candidates);

  private:
    Strategy strategy_;
    std::mt19937_64 random_;
};

} // namespace cd
