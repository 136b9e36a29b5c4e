// The paper's strategies that compare workers by the triangles that they hold (section 6.5 and the
// strategies of section 7).
#pragma once

#include "master/dispatch/policy/matching_policy.hpp"

#include <cstdint>
#include <vector>

namespace cd {

/// A worker that may get the scenario.
struct WorkerCandidate {
    WorkerProxy* worker = nullptr;
    /// The paper's score: the sum over both trees of scenario indicator x (held ? 1 : 0), which is
    /// the number of triangles that the worker already holds.
    std::uint64_t held_triangles = 0;
    double load = 0; ///< Buffered scenarios / q, below 1.
};

/// Collects the workers that may get a scenario of the job now, by ascending id, unscored.
void gather_candidates(const MatchingContext& context,
                       const DispatchJob& job,
                       std::vector<WorkerCandidate>& candidates);

/// Chooses the worker with the greatest `worth`. Deterministic: ties go to the worker with the
/// fewest scenarios, then to the smallest id.
class ScorePolicy : public MatchingPolicy {
  public:
    using MatchingPolicy::MatchingPolicy;

    [[nodiscard]] WorkerProxy* would_choose(const DispatchJob& job,
                                            const DispatchScenario& scenario) const final;

  protected:
    [[nodiscard]] virtual double worth(const WorkerCandidate& candidate) const = 0;

  private:
    // Scratch buffers.
    mutable std::vector<WorkerCandidate> candidates_;
    mutable std::vector<std::uint64_t> held_triangles_; ///< Indexed by slot.
};

} // namespace cd
