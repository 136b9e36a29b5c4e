#include "master/matchmaker.hpp"

namespace cd {

namespace {

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

std::optional<WorkerId> Matchmaker::choose(std::span<const WorkerCandidate> candidates) {
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
        const double value = worth(strategy_, candidate.held_triangles, candidate.load);
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
