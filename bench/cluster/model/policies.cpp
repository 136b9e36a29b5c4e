#include "bench/cluster/model/policies.hpp"

#include "bench/cluster/paper/one_by_one.hpp"
#include "master/dispatch/policy/best_match_pull.hpp"
#include "master/dispatch/policy/earliest_finish.hpp"

#include <array>
#include <tuple>
#include <vector>

namespace cd::bench {

namespace {

/// Chooses a client's scenarios one at a time. Each choice counts the blocks of the scenarios
/// chosen before it as held. Ignores the limit V, which the paper's experiments never reach.
template <Likeness likeness>
class OneByOnePull final : public BestMatchPull {
  public:
    using BestMatchPull::BestMatchPull;

    [[nodiscard]] std::vector<std::size_t> pulled(const WorkerProxy& proxy,
                                                  const DispatchJob& job) const override {
        std::vector<Candidate> candidates;
        candidates.reserve(job.waiting.size());
        for (const std::uint64_t position : job.waiting) {
            candidates.push_back(candidate(proxy, job.at(position).roots));
        }
        return choose_one_by_one(candidates, job.options.q, likeness);
    }

  private:
    [[nodiscard]] Candidate candidate(const WorkerProxy& proxy, const ScenarioRoots& roots) const {
        Candidate candidate;
        for (const auto& [tree, touched] : roots) {
            const RootHolders& holders = context().plan.tree(tree).held;
            for (const auto& [root, triangles] : touched) {
                if (holders.holds(proxy.slot(), root)) {
                    candidate.held_triangles += triangles;
                } else {
                    candidate.missing.push_back({tree.value << 32U | root, triangles});
                }
            }
        }
        return candidate;
    }
};

class RandomPull final : public BestMatchPull {
  public:
    RandomPull(const MatchingContext& context, const ClusterOptions& options)
        : BestMatchPull(context, options), seed_(options.seed) {}

  private:
    /// The finaliser of splitmix64.
    [[nodiscard]] std::uint64_t score(const WorkerProxy& /*proxy*/,
                                      const DispatchJob& /*job*/,
                                      std::uint64_t position) const override {
        std::uint64_t mixed = (seed_ << 32U) + position + 0x9e3779b97f4a7c15U;
        mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9U;
        mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebU;
        return mixed ^ (mixed >> 31U);
    }

    std::uint64_t seed_;
};

class BlindEarliestFinish final : public EarliestFinish {
  public:
    using EarliestFinish::EarliestFinish;

    [[nodiscard]] WorkerProxy* would_choose(const DispatchJob& job,
                                            const DispatchScenario& scenario) const override {
        WorkerProxy* best = nullptr;
        double best_seconds = 0;
        for (WorkerProxy* proxy : context().pool.in_order()) {
            if (!may_take(*proxy, job)) {
                continue;
            }
            const double seconds = finish_on(*proxy, job, scenario).total();
            if (best == nullptr || std::tuple(seconds, proxy->scenarios()) <
                                       std::tuple(best_seconds, best->scenarios())) {
                best = proxy;
                best_seconds = seconds;
            }
        }
        return best;
    }
    [[nodiscard]] FinishTerms finish_on(const WorkerProxy& proxy,
                                        const DispatchJob& /*job*/,
                                        const DispatchScenario& scenario) const override {
        ScenarioNeeds needs;
        needs.cost_ns = scenario.weight.cost_ns;
        return estimate_finish(context().pace.powers_of(proxy, context().plan), needs);
    }
};

constexpr std::array client_first{
    RegisteredStrategy{"best-match", make_as<OneByOnePull<Likeness::Most>>},
    RegisteredStrategy{"random", make_as<RandomPull>},
    RegisteredStrategy{"lowest", make_as<OneByOnePull<Likeness::Least>>},
};
constexpr std::array blind{RegisteredStrategy{"earliest-finish", make_as<BlindEarliestFinish>}};

} // namespace

std::span<const RegisteredStrategy> strategies_with(Variation variation) {
    switch (variation) {
    case Variation::None:
        return registered_strategies();
    case Variation::ClientFirst:
        return client_first;
    case Variation::Blind:
        return blind;
    }
    return {};
}

} // namespace cd::bench
