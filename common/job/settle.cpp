#include "common/job/settle.hpp"

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

Settler::Settler(const ObbTree& a, const ObbTree& b, std::vector<IgnoredRange> ignored)
    : a_(a),
      b_(b),
      ignored_(std::move(ignored)),
      are_closed_(a.topology().is_closed() && b.topology().is_closed()) {}

const Settler::Probes& Settler::probes() const {
    std::call_once(once_, [this] {
        probes_ = {inside_probes(a_, b_, ignored_), inside_probes(b_, a_, swapped(ignored_))};
    });
    return probes_;
}

bool Settler::is_inside(const PosePair& poses, SettleStatistics& statistics) const {
    return contains_component(a_, poses.a, b_, poses.b, probes().of_b, statistics) ||
           contains_component(b_, poses.b, a_, poses.a, probes().of_a, statistics);
}

bool Settler::is_cross(const PosePair& poses,
                       const ScenarioResult& result,
                       const SettleOptions& options,
                       SettleStatistics& statistics) const {
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
        found = search_again(a_, b_, poses, ignored_, options.stop, statistics);
        all = found;
    }
    return penetrates(a_, b_, poses, all, ignored_, statistics, options.stop);
}

bool Settler::is_work(const ScenarioResult& result) const {
    const bool may_change = result.kind == ScenarioClass::Separate ||
                            result.kind == ScenarioClass::Near ||
                            result.kind == ScenarioClass::Touch;
    return may_change && are_closed_ && result.question != Question::Shots;
}

bool Settler::may_be_inside(const PosePair& poses, const RelativePose* b_to_a) const {
    const BoxTest boxes(b_to_a != nullptr ? *b_to_a : relative_pose(poses));
    const ObbNode& box_a = a_.nodes()[0];
    const PosedBox box_b = boxes.pose(b_.nodes()[0]);
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
               probes().of_b,
               b_,
               [&](const ObbNode& point) { return boxes.may_overlap(box_a, boxes.pose(point)); }) ||
           may_hold_any(probes().of_a, a_, [&](const ObbNode& point) {
               return boxes.may_overlap(point, box_b);
           });
}

SettleStatistics Settler::settle_closed(const Scenario& scenario,
                                        ScenarioResult& result,
                                        const SettleOptions& options) const {
    SettleStatistics work;
    if (result.kind == ScenarioClass::Touch) {
        if (is_cross(scenario.poses, result, options, work)) {
            result.kind = ScenarioClass::Cross;
        }
    } else if (is_inside(scenario.poses, work)) {
        result.kind = ScenarioClass::Inside;
    }
    return work;
}

InsideStatistics Settler::settle(const Scenario& scenario,
                                 ScenarioResult& result,
                                 const SettleOptions& options) const {
    using Clock = std::chrono::steady_clock;
    if (result.kind == ScenarioClass::Failed || result.question == Question::Shots) {
        return {};
    }
    result.surfaces_only = !are_closed_;
    result.insides_skipped =
        are_closed_ && !ignored_.empty() && !(probes().of_a.are_all && probes().of_b.are_all);
    if (!is_work(result)) {
        return {};
    }
    // A body inside the other body lies, with its probes, in the other body's box.
    if (result.kind != ScenarioClass::Touch && !may_be_inside(scenario.poses, options.b_to_a)) {
        return {1, 0, {}};
    }
    const Clock::time_point start = Clock::now();
    const SettleStatistics work = settle_closed(scenario, result, options);
    return {1, std::chrono::duration<double>(Clock::now() - start).count(), work};
}

} // namespace cd
