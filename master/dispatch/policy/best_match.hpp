// The strategy `best-match` (paper, section 7).
#pragma once

#include "master/dispatch/policy/score_policy.hpp"

namespace cd {

class BestMatch final : public ScorePolicy {
  public:
    using ScorePolicy::ScorePolicy;

    [[nodiscard]] std::string_view why() const override {
        return "it holds the most triangles of the scenario";
    }

  protected:
    [[nodiscard]] double worth(const WorkerCandidate& candidate) const override {
        return static_cast<double>(candidate.held_triangles);
    }
};

} // namespace cd
