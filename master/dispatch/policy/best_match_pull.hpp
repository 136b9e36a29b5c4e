// The strategy `best-match-pull`: a free worker takes from the waiting scenarios (paper, 5.1).
#pragma once

#include "master/dispatch/policy/matching_policy.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

class BestMatchPull : public MatchingPolicy {
  public:
    using MatchingPolicy::MatchingPolicy;

    [[nodiscard]] WorkerProxy* would_choose(const DispatchJob& /*job*/,
                                            const DispatchScenario& /*scenario*/) const override {
        return nullptr;
    }
    [[nodiscard]] bool may_take(const WorkerProxy& proxy, const DispatchJob& job) const override;
    [[nodiscard]] std::string_view why() const override { return why_none(); }
    [[nodiscard]] std::string_view why_none() const override {
        return "no worker is chosen: a free one takes the q scenarios of which it holds most";
    }
    [[nodiscard]] bool workers_pull() const override { return true; }
    /// Bounds without buffers, because workers pull their tasks from the queue.
    [[nodiscard]] WorkBounds bounds(const WorkerProxy& proxy,
                                    const DispatchJob& job) const override {
        return {0, job.options.q, proxy.tasks_max(job.options)};
    }
    /// Fewer than q scenarios may be pulled only if the input is paused and the worker runs dry.
    [[nodiscard]] bool can_pull(const WorkerProxy& proxy, const DispatchJob& job) const override;
    [[nodiscard]] std::vector<std::size_t> pulled(const WorkerProxy& proxy,
                                                  const DispatchJob& job) const override;

    /// The indices of the `count` highest scores, ascending. Ties go to the smaller index.
    [[nodiscard]] static std::vector<std::size_t>
    most_similar(std::span<const std::uint64_t> scores, std::size_t count);

  protected:
    /// Similarity of the waiting scenario at the position to the worker.
    [[nodiscard]] virtual std::uint64_t
    score(const WorkerProxy& proxy, const DispatchJob& job, std::uint64_t position) const;
};

} // namespace cd
