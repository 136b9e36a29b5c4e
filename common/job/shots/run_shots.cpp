#include "common/job/shots/run_shots.hpp"

#include "common/job/shots/bundle_shots.hpp"
#include "common/shots/segment_hit.hpp"
#include "common/tree/ignored_range.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace cd {

namespace {

HitStage stage_for(PairStage first) {
    switch (first) {
    case PairStage::Float:
    case PairStage::Double:
    case PairStage::Lattice:
        return HitStage::Double;
    case PairStage::DoubleDouble:
        return HitStage::DoubleDouble;
    case PairStage::WideInteger:
        return HitStage::Integer;
    case PairStage::Arbitrary:
        break;
    }
    return HitStage::Exact;
}

/// The pairs of a scenario in contact, with the hits among them.
struct Shots {
    std::vector<ContactPair> pairs;
    std::span<const PairCorners> corners;
    std::vector<PairHit> hits;
    std::vector<bool> are_kept; ///< The pairs that the query asks for.

    /// Returns the indices of the pairs by line, then by triangle of A.
    [[nodiscard]] std::vector<std::size_t> by_line() const {
        std::vector<std::size_t> order(pairs.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [&](std::size_t l, std::size_t r) {
            return std::tie(pairs[l].b, pairs[l].a) < std::tie(pairs[r].b, pairs[r].a);
        });
        return order;
    }

    /// Finds the hits of one line, whose pairs are given.
    void find_line(SegmentHit& engine, std::span<const std::size_t> of_line, bool only_first) {
        std::vector<Corners> triangles;
        for (const std::size_t i : of_line) {
            triangles.push_back(corners[i].a);
        }
        const Corners& line = corners[of_line.front()].b;
        for (const LineHit& hit : engine.hits(triangles, {line[0], line[1]})) {
            const std::size_t i = of_line[hit.triangle];
            const bool crosses = (hit.flags & hit_flag::crosses) != 0;
            hits[i] = {hit.depth, hit.flags, hit.rank};
            are_kept[i] = crosses || !only_first;
            if (crosses && only_first) {
                break;
            }
        }
    }

    /// Finds the hits of all lines. Returns false if `stop` ended that.
    [[nodiscard]] bool find(SegmentHit& engine, bool only_first, const StopCheck& stop) {
        hits.resize(pairs.size());
        are_kept.resize(pairs.size());
        const std::vector<std::size_t> order = by_line();
        for (auto from = order.begin(); from != order.end();) {
            const auto to = std::find_if(
                from, order.end(), [&](std::size_t i) { return pairs[i].b != pairs[*from].b; });
            if (stop && stop()) {
                return false;
            }
            find_line(engine, {from, to}, only_first);
            from = to;
        }
        return true;
    }

    /// Removes the pairs that are not kept, and adds hits that are settled.
    void merge(SettledHits settled) {
        if (pairs.empty()) {
            pairs = std::move(settled.pairs);
            hits = std::move(settled.hits);
            return;
        }
        SettledHits all;
        all.pairs.reserve(pairs.size() + settled.pairs.size());
        all.hits.reserve(all.pairs.capacity());
        auto next = settled.pairs.begin();
        const auto add_settled = [&](std::vector<ContactPair>::iterator end) {
            const auto hit = settled.hits.begin() + (next - settled.pairs.begin());
            all.hits.insert(all.hits.end(), hit, hit + (end - next));
            all.pairs.insert(all.pairs.end(), next, end);
            next = end;
        };
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if (are_kept[i]) {
                add_settled(std::find_if(next, settled.pairs.end(), [&](const ContactPair& pair) {
                    return pairs[i] < pair;
                }));
                all.pairs.push_back(pairs[i]);
                all.hits.push_back(hits[i]);
            }
        }
        add_settled(settled.pairs.end());
        pairs = std::move(all.pairs);
        hits = std::move(all.hits);
    }

    [[nodiscard]] std::vector<ContactPair> crossings() const {
        std::vector<ContactPair> crossings;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if ((hits[i].flags & hit_flag::crosses) != 0) {
                crossings.push_back(pairs[i]);
            }
        }
        return crossings;
    }
};

void set_count(std::uint64_t count, ScenarioResult& result) {
    result.pair_count = count;
    result.kind = count > 0 ? ScenarioClass::Contact : ScenarioClass::Separate;
}

ScenarioResult too_many(std::uint64_t count, const Scenario& scenario, const Query& query) {
    return failed_result(scenario,
                         query,
                         {ErrorCode::TooLarge,
                          std::to_string(count) +
                              " hits are too many for one bundle of lines; use smaller ones, or "
                              "ask for level count without maps and first hits"});
}

void list_hits(Shots& shots, const Query& query, ScenarioResult& result) {
    if (query.limit_pairs != 0 && shots.pairs.size() > query.limit_pairs) {
        shots.pairs.resize(query.limit_pairs);
        shots.hits.resize(query.limit_pairs);
    }
    result.pairs = std::move(shots.pairs);
    result.hits = std::move(shots.hits);
}

/// Finds the hits under all pairs. Returns false if `stop` ended that.
bool collect(KeptSearch& kept, std::span<const SubtreePair> pairs, const RunOptions& options) {
    using Collected = BundleShots::Collected;
    // Doubles decide bundles, so that a later first stage leaves nothing to them.
    const bool tries_bundles =
        options.first_stage <= PairStage::Double && options.decision == PairDecision::Exact;
    for (const SubtreePair& pair : pairs) {
        const Collected collected =
            tries_bundles ? kept.bundles->collect(pair, kept.search->contacts(), options.stop)
                          : Collected::None;
        if (collected == Collected::Stopped) {
            return false;
        }
        if (collected == Collected::None) {
            kept.search->collect(pair.a, pair.b);
        }
    }
    return true;
}

} // namespace

bool needs_hits(const Query& query) {
    return query.level >= Level::Pairs || query.maps || query.first_hits;
}

bool find_shots(KeptSearch& kept,
                std::span<const SubtreePair> pairs,
                const Scenario& scenario,
                const Query& query,
                const RunOptions& options,
                ScenarioRun& run) {
    BundleShots& bundles = kept.bundles ? *kept.bundles : kept.bundles.emplace();
    bundles.restart(scenario.poses,
                    ignored_of(query.ignored, scenario.body_a, scenario.body_b),
                    needs_hits(query));
    if (!collect(kept, pairs, options)) {
        return false;
    }
    run.statistics += bundles.statistics();
    FoundContacts& found = kept.search->contacts();
    const std::uint64_t count = bundles.count() + found.count();
    if (!needs_hits(query)) {
        set_count(count, run.result);
        return true;
    }
    if (count > found.pairs_max()) {
        run.result = too_many(count, scenario, query);
        return true;
    }
    SettledHits settled = bundles.settle(found, query.first_hits);
    found.sort();
    Shots shots;
    shots.pairs = found.take_pairs();
    shots.corners = found.corners();
    if (kept.lines) {
        kept.lines->restart(scenario.poses);
    } else {
        kept.lines.emplace(scenario.poses, stage_for(options.first_stage));
    }
    if (!shots.find(*kept.lines, query.first_hits, options.stop)) {
        return false;
    }
    shots.merge(std::move(settled));
    set_count(shots.pairs.size(), run.result);
    if (query.maps) {
        run.found = shots.crossings();
    }
    if (query.level >= Level::Pairs) {
        list_hits(shots, query, run.result);
    }
    return true;
}

} // namespace cd
