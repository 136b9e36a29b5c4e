#include "common/job/run_scenario.hpp"

#include "common/core/limits.hpp"
#include "common/job/settle.hpp"

#include <algorithm>

namespace cd {

namespace {

ScenarioResult empty_result(const Scenario& scenario, const Query& query) {
    ScenarioResult result;
    result.index = scenario.index;
    result.body_a = scenario.body_a;
    result.body_b = scenario.body_b;
    result.level = query.level;
    return result;
}

/// Touch or cross, as far as pairs alone can tell.
ScenarioClass class_of(std::span<const ContactPair> pairs) {
    if (pairs.empty()) {
        return ScenarioClass::Separate;
    }
    const bool is_proper = std::any_of(pairs.begin(), pairs.end(), [](const ContactPair& pair) {
        return pair.kind == PairClass::Proper;
    });
    return is_proper ? ScenarioClass::Cross : ScenarioClass::Touch;
}

void find_any(std::span<const SubtreePair> pairs, ContactSearch& search, ScenarioResult& result) {
    const bool touches = std::any_of(pairs.begin(), pairs.end(), [&](const SubtreePair& pair) {
        return search.any(pair.a, pair.b);
    });
    result.kind = touches ? ScenarioClass::Contact : ScenarioClass::Separate;
}

/// Keeps no pairs: memory is that of one pair of subtrees.
void find_count(std::span<const SubtreePair> pairs, ContactSearch& search, ScenarioResult& result) {
    for (const SubtreePair& pair : pairs) {
        search.collect(pair.a, pair.b);
        result.pair_count += search.pairs().size();
        if (result.kind != ScenarioClass::Cross && !search.pairs().empty()) {
            result.kind = class_of(search.pairs());
        }
        search.pairs().clear();
    }
}

void add_shared_points(ContactSearch& search, ScenarioResult& result) {
    result.point_offsets.push_back(0);
    for (std::size_t i = 0; i < result.pairs.size(); ++i) {
        const PairCorners& corners = search.corners()[i];
        result.point_origins.push_back(search.test().point_origin(corners.a));
        const std::span<const Vec3> points = search.test().shared_points(corners.a, corners.b);
        result.points.insert(result.points.end(), points.begin(), points.end());
        result.point_offsets.push_back(static_cast<std::uint32_t>(result.points.size()));
    }
}

void find_pairs(std::span<const SubtreePair> pairs,
                const Query& query,
                ContactSearch& search,
                ScenarioResult& result) {
    for (const SubtreePair& pair : pairs) {
        search.collect(pair.a, pair.b);
    }
    search.sort();
    result.pairs = std::move(search.pairs());
    result.pair_count = result.pairs.size();
    // The class is that of all pairs, also of those that the limit cuts.
    result.kind = class_of(result.pairs);
    if (query.limit_pairs != 0 && result.pairs.size() > query.limit_pairs) {
        result.pairs.resize(query.limit_pairs);
    }
    if (query.level == Level::Contacts) {
        add_shared_points(search, result);
    }
}

} // namespace

ScenarioRun
run_on_subtrees(std::span<const SubtreePair> pairs, const Scenario& scenario, const Query& query) {
    ScenarioRun run;
    run.result = empty_result(scenario, query);
    if (pairs.empty()) {
        if (query.level == Level::Contacts) {
            run.result.point_offsets.push_back(0);
        }
        return run;
    }
    SearchOptions options;
    options.keep_corners = query.level == Level::Contacts;
    ContactSearch search(scenario.poses, query.ignored, options);
    switch (query.level) {
    case Level::Any:
        find_any(pairs, search, run.result);
        break;
    case Level::Count:
        find_count(pairs, search, run.result);
        break;
    case Level::Pairs:
    case Level::Contacts:
        find_pairs(pairs, query, search, run.result);
        break;
    }
    run.statistics = search.statistics();
    run.result = within_limit(std::move(run.result), limits::result_record_bytes_max);
    return run;
}

ScenarioRun
run_scenario(const ObbTree& a, const ObbTree& b, const Scenario& scenario, const Query& query) {
    const SubtreePair whole{a.view(), b.view()};
    ScenarioRun run = run_on_subtrees({&whole, 1}, scenario, query);
    run.settling = settle_class(a, b, scenario, query, run.result);
    return run;
}

} // namespace cd
