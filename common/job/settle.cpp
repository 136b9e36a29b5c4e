#include "common/job/settle.hpp"

#include "common/tree/containment.hpp"
#include "common/tree/penetration.hpp"
#include "common/tree/traverse.hpp"

#include <chrono>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// As B sees them.
std::vector<IgnoredRange> swapped(std::span<const IgnoredRange> ignored) {
    std::vector<IgnoredRange> result;
    for (const IgnoredRange& range : ignored) {
        result.push_back({range.b_begin, range.b_end, range.a_begin, range.a_end});
    }
    return result;
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
    ContactSearch search(poses, ignored, options);
    search.collect(a.view(), b.view());
    search.sort();
    return search.take_pairs();
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
    if (all.size() != result.pair_count) {
        all = options.touches;
    }
    if (all.size() != result.pair_count) {
        found = search_again(a_, b_, poses, ignored_, options.stop, statistics);
        all = found;
    }
    return penetrates(a_, b_, poses, all, ignored_, statistics, options.stop);
}

bool Settler::is_work(const ScenarioResult& result) const {
    const bool may_change =
        result.kind == ScenarioClass::Separate || result.kind == ScenarioClass::Touch;
    return may_change && are_closed_;
}

SettleStatistics Settler::settle(const Scenario& scenario,
                                 ScenarioResult& result,
                                 const SettleOptions& options) const {
    SettleStatistics statistics;
    if (result.kind == ScenarioClass::Failed) {
        return statistics;
    }
    result.surfaces_only = !are_closed_;
    result.insides_skipped =
        are_closed_ && !ignored_.empty() && !(probes().of_a.are_all && probes().of_b.are_all);
    if (!is_work(result)) {
        return statistics;
    }
    if (result.kind == ScenarioClass::Touch) {
        if (is_cross(scenario.poses, result, options, statistics)) {
            result.kind = ScenarioClass::Cross;
        }
    } else if (is_inside(scenario.poses, statistics)) {
        result.kind = ScenarioClass::Inside;
    }
    return statistics;
}

InsideStatistics settle_with_cost(const Settler& settler,
                                  const Scenario& scenario,
                                  ScenarioResult& result,
                                  const SettleOptions& options) {
    using Clock = std::chrono::steady_clock;
    const bool is_work = settler.is_work(result);
    const Clock::time_point start = is_work ? Clock::now() : Clock::time_point();
    const SettleStatistics work = settler.settle(scenario, result, options);
    if (!is_work) {
        return {0, 0, work};
    }
    return {1, std::chrono::duration<double>(Clock::now() - start).count(), work};
}

} // namespace cd
