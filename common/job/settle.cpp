#include "common/job/settle.hpp"

#include "common/job/answer_poses.hpp"
#include "common/search/contact_search.hpp"
#include "common/solid/containment.hpp"
#include "common/solid/penetration.hpp"
#include "common/tree/box_test.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// Exchanges the roles of A and B in ignored ranges.
std::vector<IgnoredRange> swapped(std::span<const IgnoredRange> ignored) {
    std::vector<IgnoredRange> result;
    for (const IgnoredRange& range : ignored) {
        result.push_back({range.b_begin, range.b_end, range.a_begin, range.a_end});
    }
    return result;
}

/// Returns a box of the smallest size around one point.
ObbNode point_box(const Vec3& point) {
    ObbNode box;
    box.center = {point.x(), point.y(), point.z()};
    box.axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    box.half.fill(std::numeric_limits<float>::min());
    return box;
}

std::vector<ContactPair> search_again(const ObbTree& a,
                                      const ObbTree& b,
                                      const PosePair& poses,
                                      std::span<const IgnoredRange> ignored,
                                      const StopCheck& stop,
                                      SettleStatistics& statistics) {
    ++statistics.searches;
    SearchOptions options;
    options.stop = stop;
    const auto search = make_search(a.view(), b.view(), poses, ignored, options);
    search->collect(a.view(), b.view());
    search->contacts().sort();
    return search->contacts().take_pairs();
}

} // namespace

Settler::Settler(TreesByBody trees, std::vector<IgnoredRange> ignored)
    : trees_(std::move(trees)), ignored_(std::move(ignored)) {
    for (const ObbTree* tree : trees_.all()) {
        of_trees_.try_emplace(tree);
    }
    for (const IgnoredRange& range : ignored_) {
        of_pairs_.try_emplace({range.body_a, range.body_b});
        of_pairs_.try_emplace({range.body_b, range.body_a});
    }
}

bool Settler::are_closed(std::uint32_t body_a, std::uint32_t body_b) const {
    return trees_.of(body_a).topology().is_closed() && trees_.of(body_b).topology().is_closed();
}

const InsideProbes& Settler::probes(std::uint32_t inner, std::uint32_t outer) const {
    const ObbTree& tree = trees_.of(inner);
    const auto of_pair = of_pairs_.find({inner, outer});
    LazyProbes& lazy = of_pair == of_pairs_.end() ? of_trees_.at(&tree) : of_pair->second;
    std::call_once(lazy.once, [&] {
        const auto [a, b] = std::minmax(inner, outer);
        const auto ignored = ignored_of(ignored_, a, b);
        const ObbTree& outer_tree = trees_.of(outer);
        lazy.probes = inner == a ? inside_probes(tree, outer_tree, ignored)
                                 : inside_probes(tree, outer_tree, swapped(ignored));
    });
    return lazy.probes;
}

bool Settler::is_inside(const Scenario& scenario, SettleStatistics& statistics) const {
    const ObbTree& a = trees_.a_of(scenario);
    const ObbTree& b = trees_.b_of(scenario);
    const PosePair& poses = scenario.poses;
    return contains_component(a, poses.a, b, poses.b, probes_of_b(scenario), statistics) ||
           contains_component(b, poses.b, a, poses.a, probes_of_a(scenario), statistics);
}

bool Settler::is_cross(const Scenario& scenario,
                       const ScenarioResult& result,
                       const SettleOptions& options,
                       SettleStatistics& statistics) const {
    const ObbTree& a = trees_.a_of(scenario);
    const ObbTree& b = trees_.b_of(scenario);
    const auto ignored = ignored_in(scenario);
    std::vector<ContactPair> found;
    std::span<const ContactPair> all = result.pairs;
    if (result.near_count > 0) { // `penetrates` is given the contacts alone.
        std::ranges::copy_if(options.touches.empty() ? all : options.touches,
                             std::back_inserter(found),
                             [](const ContactPair& pair) { return pair.kind != PairClass::Near; });
        all = found;
    } else if (all.size() != result.pair_count) {
        all = options.touches;
    }
    if (all.size() != result.pair_count) {
        found = search_again(a, b, scenario.poses, ignored, options.stop, statistics);
        all = found;
    }
    return penetrates(a, b, scenario.poses, all, ignored, statistics, options.stop);
}

bool Settler::is_work(const ScenarioResult& result) const {
    const bool may_change = result.kind == ScenarioClass::Separate ||
                            result.kind == ScenarioClass::Near ||
                            result.kind == ScenarioClass::Touch;
    return may_change && result.question != Question::Shots &&
           are_closed(result.body_a, result.body_b);
}

bool Settler::may_be_inside(const Scenario& scenario, const RelativePose* b_to_a) const {
    const ObbTree& a = trees_.a_of(scenario);
    const ObbTree& b = trees_.b_of(scenario);
    const BoxTest boxes(b_to_a != nullptr ? *b_to_a : relative_pose(scenario.poses));
    const ObbNode& box_a = a.nodes()[0];
    const PosedBox box_b = boxes.pose(b.nodes()[0]);
    if (!boxes.may_overlap(box_a, box_b)) {
        return false;
    }
    const auto may_hold_any = [](const InsideProbes& probes, const ObbTree& inner, auto may_hold) {
        return std::ranges::any_of(probes.groups, [&](const ProbeGroup& group) {
            return std::ranges::any_of(group.triangles, [&](std::uint32_t triangle) {
                return may_hold(point_box(inner.mesh().corners(triangle)[0]));
            });
        });
    };
    return may_hold_any(
               probes_of_b(scenario),
               b,
               [&](const ObbNode& point) { return boxes.may_overlap(box_a, boxes.pose(point)); }) ||
           may_hold_any(probes_of_a(scenario), a, [&](const ObbNode& point) {
               return boxes.may_overlap(point, box_b);
           });
}

SettleStatistics Settler::settle_closed(const Scenario& scenario,
                                        ScenarioResult& result,
                                        const SettleOptions& options) const {
    SettleStatistics work;
    if (result.kind == ScenarioClass::Touch) {
        if (is_cross(scenario, result, options, work)) {
            result.kind = ScenarioClass::Cross;
        }
    } else if (is_inside(scenario, work)) {
        result.kind = ScenarioClass::Inside;
    }
    return work;
}

bool Settler::decides_insides(std::uint32_t body_a, std::uint32_t body_b) const {
    return ignored_of(ignored_, body_a, body_b).empty() ||
           (probes(body_a, body_b).are_all && probes(body_b, body_a).are_all);
}

void Settler::set_flags(ScenarioResult& result) const {
    if (result.kind == ScenarioClass::Failed || result.question == Question::Shots) {
        return;
    }
    const bool is_closed = are_closed(result.body_a, result.body_b);
    result.surfaces_only = !is_closed;
    result.insides_skipped = is_closed && !decides_insides(result.body_a, result.body_b);
}

InsideStatistics Settler::settle(const Scenario& scenario,
                                 ScenarioResult& result,
                                 const SettleOptions& options) const {
    if (result.kind == ScenarioClass::Failed || result.question == Question::Shots) {
        return {};
    }
    return result.question == Question::Motion
               ? settle_at(at_answer(scenario, result), result, options)
               : settle_at(scenario, result, options);
}

InsideStatistics Settler::settle_at(const Scenario& scenario,
                                    ScenarioResult& result,
                                    const SettleOptions& options) const {
    using Clock = std::chrono::steady_clock;
    set_flags(result);
    if (!is_work(result)) {
        return {};
    }
    // A body inside the other body lies, with its probes, in the other body's box.
    if (result.kind != ScenarioClass::Touch && !may_be_inside(scenario, options.b_to_a)) {
        return {1, 0, {}};
    }
    const Clock::time_point start = Clock::now();
    const SettleStatistics work = settle_closed(scenario, result, options);
    return {1, std::chrono::duration<double>(Clock::now() - start).count(), work};
}

} // namespace cd
