#include "master/dispatch/policy/matchmaker.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace cd {

namespace {

/// Score; the candidate with the highest wins.
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
    case Strategy::BestMatchPull:
    case Strategy::EarliestFinish:
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
        // The modulo bias is below workers / 2^64.
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

std::vector<std::size_t> Matchmaker::most_similar(std::span<const std::uint64_t> scores,
                                                  std::size_t count) {
    std::vector<std::size_t> places(scores.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    count = std::min(count, places.size());
    const auto end = places.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(places.begin(), end, places.end(), [&](std::size_t one, std::size_t other) {
        return std::tuple(scores[other], one) < std::tuple(scores[one], other);
    });
    places.erase(end, places.end());
    std::sort(places.begin(), places.end());
    return places;
}

} // namespace cd
