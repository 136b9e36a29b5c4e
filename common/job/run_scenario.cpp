#include "common/job/run_scenario.hpp"

#include "common/core/limits.hpp"
#include "common/job/tolerance.hpp"

#include <algorithm>
#include <optional>
#include <string>

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

/// What was found, also of pairs that are not kept; the class as far as pairs alone can tell.
void note_found(const ContactSearch& search, ScenarioResult& result) {
    result.pair_count = search.pair_count();
    if (result.pair_count > 0) {
        result.kind = search.has_proper() ? ScenarioClass::Cross : ScenarioClass::Touch;
    }
}

/// Boxes that were left take the class over, but not what was proven.
void note_undecided(const ContactSearch& search, ScenarioResult& result) {
    if (const std::optional<double> distance = search.undecided_distance()) {
        result.kind = ScenarioClass::Undecided;
        result.distance_bound = result.pair_count > 0 ? 0 : *distance;
    }
}

void find_any(std::span<const SubtreePair> pairs, ContactSearch& search, ScenarioResult& result) {
    const bool touches = std::any_of(pairs.begin(), pairs.end(), [&](const SubtreePair& pair) {
        return search.any(pair.a, pair.b);
    });
    if (touches) {
        result.kind = ScenarioClass::Contact;
    } else {
        note_undecided(search, result);
    }
}

void find_count(std::span<const SubtreePair> pairs, ContactSearch& search, ScenarioResult& result) {
    for (const SubtreePair& pair : pairs) {
        search.collect(pair.a, pair.b);
    }
    note_found(search, result);
    note_undecided(search, result);
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

/// How many pairs a result can have: with one more, `within_limit` makes a failure of it.
std::uint64_t pairs_worth_keeping(const Query& query) {
    if (query.limit_pairs != 0) {
        return query.limit_pairs;
    }
    constexpr std::uint64_t pair_bytes = 2 * sizeof(std::uint32_t) + 1;
    constexpr std::uint64_t points_bytes = 2 * 3 * sizeof(double); // An origin and one point.
    const std::uint64_t bytes = pair_bytes + (query.level == Level::Contacts ? points_bytes : 0);
    return limits::result_record_bytes_max / bytes + 1;
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
    note_found(search, result);
    note_undecided(search, result);
    if (query.level == Level::Contacts) {
        add_shared_points(search, result);
    }
}

} // namespace

ScenarioResult failed_result(const Scenario& scenario, const Query& query, const Error& why) {
    ScenarioResult result = empty_result(scenario, query);
    result.kind = ScenarioClass::Failed;
    result.failure = "scenario " + std::to_string(scenario.index) + ": " + why.detail;
    return result;
}

ScenarioRun run_on_subtrees(std::span<const SubtreePair> pairs,
                            const Scenario& scenario,
                            const Query& query,
                            PairStage first_stage) {
    ScenarioRun run;
    run.result = empty_result(scenario, query);
    if (pairs.empty()) {
        if (query.level == Level::Contacts) {
            run.result.point_offsets.push_back(0);
        }
        return run;
    }
    SearchOptions options;
    options.keep_pairs = query.level >= Level::Pairs;
    options.keep_corners = query.level == Level::Contacts;
    options.pairs_max = pairs_worth_keeping(query);
    options.tolerance = query.tolerance;
    options.first_stage = first_stage;
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

ScenarioRunner::ScenarioRunner(const ObbTree& a,
                               const ObbTree& b,
                               const Query& query,
                               PairStage first_stage)
    : a_(a), b_(b), query_(query), first_stage_(first_stage) {
    if (query.tolerance > 0) {
        cut_a_ = cut(a);
        cut_b_ = &a == &b ? cut_a_ : cut(b);
    }
}

std::shared_ptr<const ScenarioRunner::CutTree> ScenarioRunner::cut(const ObbTree& tree) {
    const std::uint32_t depth = tolerance_depth(tree);
    CutTree cut{cut_tree(tree, depth), {}};
    for (const std::uint32_t node : cut_nodes(tree, depth)) {
        cut.subtrees.push_back(extract_subtree(tree, node));
    }
    return std::make_shared<const CutTree>(std::move(cut));
}

ScenarioRun ScenarioRunner::run_on_cuts(const Scenario& scenario) const {
    const Result<std::vector<RootPair>> roots =
        colliding_roots(cut_a_->top, cut_b_->top, scenario.poses);
    if (!roots) {
        return {failed_result(scenario, query_, roots.error()), {}, {}};
    }
    std::vector<SubtreePair> pairs;
    pairs.reserve(roots.value().size());
    for (const RootPair& pair : roots.value()) {
        pairs.push_back({cut_a_->subtrees[pair.a].view(), cut_b_->subtrees[pair.b].view()});
    }
    return run_on_subtrees(pairs, scenario, query_, first_stage_);
}

ScenarioRun ScenarioRunner::run(const Scenario& scenario) const {
    const SubtreePair whole{a_.view(), b_.view()};
    ScenarioRun run = cut_a_ ? run_on_cuts(scenario)
                             : run_on_subtrees({&whole, 1}, scenario, query_, first_stage_);
    run.inside = settle_with_cost(a_, b_, scenario, query_, run.result);
    return run;
}

ScenarioRun
run_scenario(const ObbTree& a, const ObbTree& b, const Scenario& scenario, const Query& query) {
    return ScenarioRunner(a, b, query).run(scenario);
}

} // namespace cd
