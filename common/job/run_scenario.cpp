#include "common/job/run_scenario.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"
#include "common/job/answer_poses.hpp"
#include "common/job/run_motion.hpp"
#include "common/job/settle.hpp"
#include "common/job/shots/run_shots.hpp"
#include "common/search/contact_search.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace cd {

namespace {

/// Starts a result without contacts.
void begin_result(const Scenario& scenario, const Query& query, ScenarioResult& result) {
    result.index = scenario.index;
    result.body_a = scenario.body_a;
    result.body_b = scenario.body_b;
    result.level = query.level;
    result.has_clearance = query.clearance.has_value();
    result.question = query.question;
    result.step = scenario.step;
}

/// Sets the number of pairs found, including pairs not kept, and the class that they determine.
void note_found(const FoundContacts& found, ScenarioResult& result) {
    result.pair_count = found.count();
    result.near_count = found.near_count();
    if (result.pair_count > 0) {
        result.kind = found.has_proper() ? ScenarioClass::Cross : ScenarioClass::Touch;
    } else if (result.near_count > 0) {
        result.kind = ScenarioClass::Near;
    }
}

/// Returns the index of the first pair for which `is_found` holds.
template <class IsFound>
std::optional<std::size_t> find_first(std::span<const SubtreePair> pairs, const IsFound& is_found) {
    const auto found = std::ranges::find_if(pairs, is_found);
    return found == pairs.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - pairs.begin()));
}

/// Returns the index of the first pair found to touch.
std::optional<std::size_t> find_touching(std::span<const SubtreePair> pairs,
                                         ContactSearch& search) {
    return find_first(pairs, [&](const SubtreePair& pair) { return search.any(pair.a, pair.b); });
}

/// Returns the index of the first pair found to touch. With a clearance, near pairs are looked for
/// first: bodies without one need no search for contacts.
std::optional<std::size_t>
find_any(std::span<const SubtreePair> pairs, ContactSearch& search, ScenarioResult& result) {
    Nearness nearness = Nearness::Near;
    std::optional<std::size_t> found;
    if (result.has_clearance) {
        found = find_first(pairs, [&](const SubtreePair& pair) {
            nearness = search.any_near(pair.a, pair.b);
            return nearness != Nearness::Far;
        });
        if (!found) {
            return std::nullopt;
        }
    }
    if (nearness != Nearness::Contact) {
        found = find_touching(pairs, search);
    }
    if (found) {
        result.kind = ScenarioClass::Contact;
    } else if (result.has_clearance) {
        result.kind = ScenarioClass::Near;
    }
    return found;
}

/// Finds the nearest pair, unless the bodies touch.
std::optional<std::size_t>
find_distance(std::span<const SubtreePair> pairs, ContactSearch& search, ScenarioResult& result) {
    if (const auto touching = find_touching(pairs, search)) {
        result.kind = ScenarioClass::Contact;
        return touching;
    }
    for (const SubtreePair& pair : pairs) {
        search.find_nearest(pair.a, pair.b);
    }
    NearestFound& found = search.nearest();
    if (const std::optional<NearestPair>& best = found.best()) {
        const NearestPoints points = found.points_of(*best);
        result.nearest = NearestWitness{best->distance,
                                        best->a,
                                        best->b,
                                        points.feature,
                                        points.origin,
                                        points.of_a,
                                        points.of_b};
    }
    return std::nullopt;
}

ScenarioResult
too_many_for_a_map(const FoundContacts& found, const Scenario& scenario, const Query& query) {
    return failed_result(scenario,
                         query,
                         {ErrorCode::TooLarge,
                          std::to_string(found.count() + found.near_count()) +
                              " pairs are too many for a map; leave out maps"});
}

void find_count(std::span<const SubtreePair> pairs,
                const Scenario& scenario,
                const Query& query,
                ContactSearch& search,
                ScenarioRun& run) {
    for (const SubtreePair& pair : pairs) {
        search.collect(pair.a, pair.b);
    }
    FoundContacts& found = search.contacts();
    note_found(found, run.result);
    const std::uint64_t expected = found.count() + (query.maps ? found.near_count() : 0);
    if (found.pairs().size() == expected) {
        found.sort();
        run.found = found.take_pairs();
    } else if (query.maps) {
        run.result = too_many_for_a_map(found, scenario, query);
    }
}

void add_points(const Vec3& origin, std::span<const Vec3> points, ScenarioResult& result) {
    result.point_origins.push_back(origin);
    result.points.insert(result.points.end(), points.begin(), points.end());
    result.point_offsets.push_back(static_cast<std::uint32_t>(result.points.size()));
}

/// Adds the nearest points of a near pair, and its distance.
void add_nearest_points(TriangleDistance& distance,
                        const PairCorners& corners,
                        ScenarioResult& result) {
    const NearestPoints nearest = distance.nearest(corners.a, corners.b);
    add_points(nearest.origin, std::array{nearest.of_a, nearest.of_b}, result);
    result.near_distances.push_back(distance.rounded(corners.a, corners.b));
}

/// Returns how many of the pairs from `begin` on are contacts, at most `most`.
std::size_t contacts_from(std::size_t begin, std::size_t most, std::span<const ContactPair> pairs) {
    const auto rest = pairs.subspan(begin, std::min(most, pairs.size() - begin));
    const auto near = std::ranges::find(rest, PairClass::Near, &ContactPair::kind);
    return static_cast<std::size_t>(near - rest.begin());
}

/// Computes the shared or nearest points of each pair. Returns false if `stop` ended the
/// computation.
bool add_all_points(FoundContacts& found, const StopCheck& stop, ScenarioResult& result) {
    constexpr std::size_t pairs_between_stop_checks = 1024;
    const auto receive = [&](const Vec3& origin, std::span<const Vec3> points) {
        add_points(origin, points, result);
    };
    const auto corners = std::span(found.corners()).first(result.pairs.size());
    result.point_offsets.reserve(corners.size() + 1);
    result.point_origins.reserve(corners.size());
    result.points.reserve(2 * corners.size()); // Nearly all pairs share a segment.
    result.point_offsets.push_back(0);
    std::size_t next_stop_check = 0;
    for (std::size_t i = 0; i < corners.size();) {
        if (i >= next_stop_check) {
            next_stop_check = i + pairs_between_stop_checks;
            if (stop && stop()) {
                return false;
            }
        }
        if (result.pairs[i].kind == PairClass::Near) {
            add_nearest_points(found.distance(), corners[i++], result);
            continue;
        }
        const std::size_t count = contacts_from(i, pairs_between_stop_checks, result.pairs);
        found.test().shared_points(corners.subspan(i, count), receive);
        i += count;
    }
    return true;
}

/// Returns how many pairs the search has to keep: `limit_pairs`, or, for a map or without that
/// limit, one more than a record can hold, which `fail_above_limit` then turns into a failure.
std::uint64_t pairs_worth_keeping(const Query& query) {
    const bool is_shots = query.question == Question::Shots; // Ranks need all hits of a line.
    if (query.limit_pairs != 0 && !query.maps && !is_shots) {
        return query.limit_pairs;
    }
    constexpr std::uint64_t pair_bytes = 2 * sizeof(std::uint32_t) + 1;
    constexpr std::uint64_t points_bytes = 2 * 3 * sizeof(double); // An origin and one point.
    const std::uint64_t bytes = pair_bytes + (query.level == Level::Contacts ? points_bytes : 0);
    return limits::result_record_bytes_max / bytes + 1;
}

/// Returns false if `stop` ended the computation of points.
bool find_pairs(std::span<const SubtreePair> pairs,
                const Scenario& scenario,
                const Query& query,
                const StopCheck& stop,
                ContactSearch& search,
                ScenarioRun& run) {
    for (const SubtreePair& pair : pairs) {
        search.collect(pair.a, pair.b);
    }
    FoundContacts& found = search.contacts();
    found.sort();
    ScenarioResult& result = run.result;
    result.pairs = found.take_pairs();
    note_found(found, result);
    if (query.maps && result.pairs.size() != result.pair_count + result.near_count) {
        result = too_many_for_a_map(found, scenario, query);
        return true;
    }
    if (query.maps) {
        run.found = result.pairs;
    }
    if (query.limit_pairs != 0 && result.pairs.size() > query.limit_pairs) {
        result.pairs.resize(query.limit_pairs);
    }
    return query.level != Level::Contacts || add_all_points(found, stop, result);
}

SearchOptions search_options(const Query& query, const RunOptions& options) {
    SearchOptions search;
    const bool is_shots = query.question == Question::Shots;
    search.only_touches =
        query.level == Level::Count && !query.maps && !is_shots && options.keep_touches;
    search.keep_pairs = query.level >= Level::Pairs || query.maps || search.only_touches ||
                        (is_shots && needs_hits(query));
    search.keep_corners = query.level == Level::Contacts || (is_shots && needs_hits(query));
    search.pairs_max = pairs_worth_keeping(query);
    search.clearance = query.clearance;
    if (query.question == Question::Motion && !search.clearance) {
        search.clearance = 0; // Set anew for each cell.
    }
    if (query.question == Question::Distance) {
        search.nearest_up_to = query.up_to.value_or(std::numeric_limits<double>::infinity());
    }
    search.first_stage = options.first_stage;
    search.decision = options.decision;
    search.stop = options.stop;
    return search;
}

/// Runs a motion; at level pairs also finds the pairs at its event. Returns false if `stop` ended
/// the run.
bool find_moving(ContactSearch& search,
                 std::span<const SubtreePair> pairs,
                 const Scenario& scenario,
                 const Query& query,
                 const RunOptions& options,
                 ScenarioRun& run) {
    const Result<Motion> motion = motion_of(scenario, query, options.radii);
    if (!motion) {
        run.result = failed_result(scenario, query, motion.error());
        return true;
    }
    const CutBodies* const cut = options.cut;
    CD_CHECK(cut != nullptr || pairs.size() == 1);
    const MovingTrees trees = cut != nullptr ? MovingTrees(cut) : MovingTrees(pairs.front());
    if (!find_motion(search, trees, motion.value(), scenario, query, options, run)) {
        return false;
    }
    if (query.level != Level::Pairs || !run.result.motion->event()) {
        return true;
    }
    std::vector<SubtreePair> at_event;
    if (cut != nullptr) {
        const PosePair poses = poses_of_answer(scenario, run.result);
        run.statistics.box_tests += cut->visit_within(
            poses, query.clearance.value_or(0), [&](const RootPair&, const SubtreePair& pair) {
                at_event.push_back(pair);
                return true;
            });
        pairs = at_event;
    }
    return find_pairs(pairs, scenario, query, options.stop, search, run);
}

/// Returns the run of a scenario without colliding roots.
ScenarioRun run_apart(const Scenario& scenario, const Query& query, const RunOptions& options) {
    ScenarioRun run;
    begin_result(scenario, query, run.result);
    if (query.level == Level::Contacts) {
        run.result.point_offsets.push_back(0);
    }
    if (query.question == Question::Motion) {
        const Result<Motion> motion = motion_of(scenario, query, options.radii);
        if (!motion) {
            run.result = failed_result(scenario, query, motion.error());
            return run;
        }
        note_free_motion(motion.value(), query, run);
    }
    return run;
}

/// Returns false if `stop` ended a computation after the search.
bool find_answer(KeptSearch& kept,
                 std::span<const SubtreePair> pairs,
                 const Scenario& scenario,
                 const Query& query,
                 const RunOptions& options,
                 ScenarioRun& run) {
    ContactSearch& search = *kept.search;
    if (query.question == Question::Shots) {
        return find_shots(kept, pairs, scenario, query, options, run);
    }
    if (query.question == Question::Motion) {
        return find_moving(search, pairs, scenario, query, options, run);
    }
    switch (query.level) {
    case Level::Any:
        kept.touching = query.question == Question::Distance
                            ? find_distance(pairs, search, run.result)
                            : find_any(pairs, search, run.result);
        break;
    case Level::Count:
        find_count(pairs, scenario, query, search, run);
        break;
    case Level::Pairs:
    case Level::Contacts:
        return find_pairs(pairs, scenario, query, options.stop, search, run);
    }
    return true;
}

ScenarioRun stopped_run(const Scenario& scenario, const Query& query) {
    ScenarioRun run;
    run.result = failed_result(scenario, query, {ErrorCode::Interrupted, "stopped"});
    run.is_stopped = true;
    return run;
}

} // namespace

ScenarioResult failed_result(const Scenario& scenario, const Query& query, const Error& why) {
    ScenarioResult result;
    begin_result(scenario, query, result);
    result.kind = ScenarioClass::Failed;
    result.failure = "scenario " + std::to_string(scenario.index) + ": " + why.detail;
    return result;
}

ScenarioRun run_on_subtrees(KeptSearch& kept,
                            std::span<const SubtreePair> pairs,
                            const Scenario& scenario,
                            const Query& query,
                            const RunOptions& options) {
    kept.touching.reset();
    if (pairs.empty()) {
        return run_apart(scenario, query, options);
    }
    ScenarioRun run;
    begin_result(scenario, query, run.result);
    const auto ignored = ignored_of(query.ignored, scenario.body_a, scenario.body_b);
    if (kept.search) {
        kept.search->ignore(ignored);
        kept.search->restart(scenario.poses);
    } else {
        kept.search = make_search(
            pairs[0].a, pairs[0].b, scenario.poses, ignored, search_options(query, options));
    }
    const bool is_whole = find_answer(kept, pairs, scenario, query, options, run);
    const SearchReport report = kept.search->report();
    if (report.is_stopped || !is_whole) {
        return stopped_run(scenario, query);
    }
    run.statistics += report.statistics;
    fail_above_limit(run.result, limits::result_record_bytes_max);
    return run;
}

ScenarioRun run_on_subtrees(std::span<const SubtreePair> pairs,
                            const Scenario& scenario,
                            const Query& query,
                            const RunOptions& options) {
    KeptSearch search;
    return run_on_subtrees(search, pairs, scenario, query, options);
}

ScenarioRunner::ScenarioRunner(TreesByBody trees,
                               const Query& query,
                               PairStage first_stage,
                               StopCheck stop)
    : trees_(std::move(trees)),
      query_(query),
      options_{{{first_stage, stop, false}, {first_stage, stop, true}}},
      radii_(radii_for(trees_, query_)),
      settler_(trees_, query.ignored) {}

ScenarioRun ScenarioRunner::run_with_kept(const Scenario& scenario, KeptSearch& kept) const {
    const ObbTree& a = trees_.a_of(scenario);
    const ObbTree& b = trees_.b_of(scenario);
    const bool are_closed = a.topology().is_closed() && b.topology().is_closed();
    RunOptions options = options_[are_closed ? 1 : 0];
    options.radii = radii_of(radii_, scenario);
    const SubtreePair whole{a.view(), b.view()};
    ScenarioRun run = run_on_subtrees(kept, {&whole, 1}, scenario, query_, options);
    if (!run.is_stopped) {
        const RelativePose* const b_to_a = kept.search->report().b_to_a;
        run.inside = settler_.settle(scenario, run.result, {run.found, options.stop, b_to_a});
    }
    if (options.stop && options.stop()) { // If it has ended `settle`, the class is meaningless.
        return stopped_run(scenario, query_);
    }
    return run;
}

ScenarioRun ScenarioRunner::run(const Scenario& scenario) const {
    KeptSearch search;
    return run_with_kept(scenario, search);
}

ScenarioRun ScenarioSession::run(const Scenario& scenario) {
    const TreesByBody& trees = runner_.trees_;
    KeptSearch& search = kept_.of(&trees.a_of(scenario), &trees.b_of(scenario));
    return runner_.run_with_kept(scenario, search);
}

ScenarioRun
run_scenario(const ObbTree& a, const ObbTree& b, const Scenario& scenario, const Query& query) {
    return ScenarioRunner(a, b, query).run(scenario);
}

} // namespace cd
