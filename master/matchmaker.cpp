#include "master/matchmaker.hpp"

#include "common/core/check.hpp"

namespace cd {

namespace {

std::uint64_t held_triangles(std::span<const ScenarioRoots::Root> roots,
                             const RootIndicator& held) {
    std::uint64_t sum = 0;
    for (const ScenarioRoots::Root& root : roots) {
        sum += held.at(root.root) != 0 ? root.triangles : 0;
    }
    return sum;
}

/// What the strategy wants to be large.
double worth(Strategy strategy, std::uint64_t score, double load) {
    const auto triangles = static_cast<double>(score);
    switch (strategy) {
    case Strategy::BestMatch:
        return triangles;
    case Strategy::BestMatchLoad:
        return triangles * (1.0 - load);
    case Strategy::Lowest:
        return -triangles;
    case Strategy::Random:
        break;
    }
    return 0;
}

} // namespace

Matchmaker::Matchmaker(Strategy strategy, std::uint64_t seed)
    : strategy_(strategy), random_(seed) {}

std::uint64_t Matchmaker::score(const ScenarioRoots& scenario, const WorkerCandidate& candidate) {
    CD_CHECK(candidate.held_a != nullptr);
    CD_CHECK(candidate.held_b != nullptr);
    return held_triangles(scenario.a, *candidate.held_a) +
           held_triangles(scenario.b, *candidate.held_b);
}

std::optional<WorkerId> Matchmaker::choose(const ScenarioRoots& scenario,
                                           std::span<const WorkerCandidate> candidates) {
    if (candidates.empty()) {
        return std::nullopt;
    }
    if (strategy_ == Strategy::Random) {
        // The bias of the remainder is below workers / 2^64.
        return candidates[random_() % candidates.size()].worker;
    }
    const WorkerCandidate* best = nullptr;
    double best_worth = 0;
    for (const WorkerCandidate& candidate : candidates) {
        const double value = worth(strategy_, score(scenario, candidate), candidate.load);
        const bool is_tie = best != nullptr && value == best_worth;
        if (best == nullptr || value > best_worth ||
            (is_tie && candidate.scenarios < best->scenarios)) {
            best = &candidate;
            best_worth = value;
        }
    }
    return best->worker;
}

} // namespace cd
