#include "bench/cluster/paper/one_by_one.hpp"

#include <algorithm>
#include <unordered_map>

namespace cd::bench {

std::vector<std::size_t>
choose_one_by_one(std::span<const Candidate> candidates, std::size_t count, Likeness likeness) {
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> lacking; // Candidates, by block.
    std::vector<std::uint64_t> held;
    std::vector<std::size_t> left;
    for (const Candidate& candidate : candidates) {
        for (const MissingBlock& missing : candidate.missing) {
            lacking[missing.block].push_back(left.size());
        }
        left.push_back(left.size());
        held.push_back(candidate.held_triangles);
    }
    const auto is_before = [&](std::size_t one, std::size_t other) {
        return likeness == Likeness::Most ? held[one] > held[other] : held[one] < held[other];
    };
    std::vector<std::size_t> chosen;
    while (chosen.size() < count && !left.empty()) {
        const auto next = std::ranges::min_element(left, is_before);
        chosen.push_back(*next);
        left.erase(next);
        for (const auto& [block, triangles] : candidates[chosen.back()].missing) {
            if (const auto found = lacking.extract(block)) {
                for (const std::size_t index : found.mapped()) {
                    held[index] += triangles;
                }
            }
        }
    }
    std::ranges::sort(chosen);
    return chosen;
}

} // namespace cd::bench
