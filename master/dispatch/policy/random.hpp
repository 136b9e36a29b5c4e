// The strategy `random` (paper, section 7): any worker that may take the scenario.
#pragma once

#include "master/dispatch/policy/score_policy.hpp"

#include <random>

namespace cd {

class RandomWorker final : public MatchingPolicy {
  public:
    RandomWorker(const MatchingContext& context, const ClusterOptions& options)
        : MatchingPolicy(context, options), random_(options.seed) {}

    [[nodiscard]] WorkerProxy* choose(const DispatchJob& job,
                                      const DispatchScenario& /*scenario*/) override {
        return draw(job, random_);
    }
    [[nodiscard]] WorkerProxy* would_choose(const DispatchJob& job,
                                            const DispatchScenario& /*scenario*/) const override {
        std::mt19937_64 copy = random_; // A draw from `random_` would change later choices.
        return draw(job, copy);
    }
    [[nodiscard]] std::string_view why() const override { return "it is drawn next"; }

  private:
    [[nodiscard]] WorkerProxy* draw(const DispatchJob& job, std::mt19937_64& random) const {
        gather_candidates(context(), job, candidates_);
        // The modulo bias is below workers / 2^64.
        return candidates_.empty() ? nullptr : candidates_[random() % candidates_.size()].worker;
    }

    std::mt19937_64 random_;
    mutable std::vector<WorkerCandidate> candidates_; ///< Scratch buffer.
};

} // namespace cd
