#include "master/compute/hit_check.hpp"

#include "common/shots/line_hit.hpp"
#include "common/shots/segment_length.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

namespace cd {

namespace {

bool crosses(const PairHit& hit) {
    return (hit.flags & hit_flag::crosses) != 0;
}

/// Returns the places of the hits by line, then by depth and rank.
std::vector<std::size_t> along_lines(const ScenarioResult& result) {
    std::vector<std::size_t> order(result.hits.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t i) {
        return std::tuple(result.pairs[i].b, result.hits[i].depth, result.hits[i].rank);
    };
    std::ranges::sort(order, {}, key);
    return order;
}

bool are_within_lines(const Mesh& lines, const ScenarioResult& result) {
    for (std::size_t i = 0; i < result.hits.size(); ++i) {
        const Corners line = lines.corners(result.pairs[i].b);
        if (result.hits[i].depth > segment_length({line[0], line[1]})) {
            return false;
        }
    }
    return true;
}

/// Ranks count from 0 among the hits of a line whose depths round alike.
bool are_ranks_whole(const ScenarioResult& result) {
    const std::vector<std::size_t> order = along_lines(result);
    for (std::size_t k = 0; k < order.size(); ++k) {
        const PairHit& hit = result.hits[order[k]];
        const bool is_first = k == 0 || result.pairs[order[k - 1]].b != result.pairs[order[k]].b ||
                              result.hits[order[k - 1]].depth != hit.depth;
        const int before = is_first ? -1 : result.hits[order[k - 1]].rank;
        if (is_first ? hit.rank != 0 : hit.rank > before + 1) {
            return false;
        }
    }
    return true;
}

bool are_first_hits(const ScenarioResult& result) {
    const std::vector<std::size_t> order = along_lines(result);
    const auto line_of = [&](std::size_t i) { return result.pairs[i].b; };
    return std::ranges::all_of(result.hits, crosses) &&
           std::ranges::adjacent_find(order, {}, line_of) == order.end();
}

/// Returns how many crossings a result has at least. A list may be cut.
std::uint64_t least_crossings(const Query& query, const ScenarioResult& result) {
    return query.first_hits
               ? result.pair_count
               : static_cast<std::uint64_t>(std::ranges::count_if(result.hits, crosses));
}

} // namespace

const char* problem_of_hits(const JobMaterial& material, const ScenarioResult& result) {
    const Mesh& lines = material.trees[result.body_b]->mesh();
    if (!are_within_lines(lines, result)) {
        return "has a hit beyond the end of its line";
    }
    if (material.query.first_hits) {
        const bool are_too_many = result.pair_count > lines.triangles().size();
        return are_too_many || !are_first_hits(result) ? "has more than first hits" : nullptr;
    }
    return result.is_cut() || are_ranks_whole(result) ? nullptr : "has ranks that skip a number";
}

std::uint64_t crossed_scenarios(const Query& query, std::span<const ScenarioResult> results) {
    return static_cast<std::uint64_t>(std::ranges::count_if(
        results, [&](const ScenarioResult& one) { return least_crossings(query, one) > 0; }));
}

Status check_crossings(const Query& query,
                       std::span<const ScenarioResult> results,
                       const ContactMap& map) {
    std::uint64_t least = 0;
    std::uint64_t most = 0;
    for (const ScenarioResult& one : results) {
        least += least_crossings(query, one);
        most += one.pair_count;
    }
    for (const auto& body : map.bodies) {
        std::uint64_t sum = 0;
        for (const TriangleContacts& triangle : body) {
            sum += triangle.scenarios;
        }
        if (sum < least || sum > most) {
            return Error{ErrorCode::BadFrame, "a map of crossings that the results do not have"};
        }
    }
    return Done{};
}

} // namespace cd
