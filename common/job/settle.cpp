#include "common/job/settle.hpp"

#include "common/tree/containment.hpp"
#include "common/tree/penetration.hpp"
#include "common/tree/traverse.hpp"

#include <chrono>
#include <utility>

namespace cd {

namespace {

bool are_closed(const ObbTree& a, const ObbTree& b) {
    return a.topology().is_closed() && b.topology().is_closed();
}

bool is_inside(const ObbTree& a,
               const ObbTree& b,
               const PosePair& poses,
               SettleStatistics& statistics) {
    return contains_component(a, poses.a, b, poses.b, statistics) ||
           contains_component(b, poses.b, a, poses.a, statistics);
}

std::vector<ContactPair> search_again(const ObbTree& a,
                                      const ObbTree& b,
                                      const PosePair& poses,
                                      const Query& query,
                                      const StopCheck& stop,
                                      SettleStatistics& statistics) {
    ++statistics.searches;
    SearchOptions options;
    options.stop = stop;
    ContactSearch search(poses, query.ignored, options);
    search.collect(a.view(), b.view());
    search.sort();
    return search.take_pairs();
}

bool is_cross(const ObbTree& a,
              const ObbTree& b,
              const PosePair& poses,
              const Query& query,
              const ScenarioResult& result,
              const SettleOptions& options,
              SettleStatistics& statistics) {
    std::vector<ContactPair> found;
    std::span<const ContactPair> all = result.pairs;
    if (all.size() != result.pair_count) {
        all = options.touches;
    }
    if (all.size() != result.pair_count) {
        found = search_again(a, b, poses, query, options.stop, statistics);
        all = found;
    }
    return penetrates(a, b, poses, all, query.ignored, statistics, options.stop);
}

} // namespace

bool settling_is_work(const ObbTree& a, const ObbTree& b, const ScenarioResult& result) {
    const bool may_change =
        result.kind == ScenarioClass::Separate || result.kind == ScenarioClass::Touch;
    return result.level >= Level::Count && may_change && are_closed(a, b);
}

SettleStatistics settle_class(const ObbTree& a,
                              const ObbTree& b,
                              const Scenario& scenario,
                              const Query& query,
                              ScenarioResult& result,
                              const SettleOptions& options) {
    result.surfaces_only = result.kind != ScenarioClass::Failed && !are_closed(a, b);
    SettleStatistics statistics;
    if (!settling_is_work(a, b, result)) {
        return statistics;
    }
    if (result.kind == ScenarioClass::Touch) {
        if (is_cross(a, b, scenario.poses, query, result, options, statistics)) {
            result.kind = ScenarioClass::Cross;
        }
    } else if (query.ignored.empty() && is_inside(a, b, scenario.poses, statistics)) {
        // (An ignored part that sticks in the other body would be "inside" it in every scenario.)
        result.kind = ScenarioClass::Inside;
    }
    return statistics;
}

InsideStatistics settle_with_cost(const ObbTree& a,
                                  const ObbTree& b,
                                  const Scenario& scenario,
                                  const Query& query,
                                  ScenarioResult& result,
                                  const SettleOptions& options) {
    using Clock = std::chrono::steady_clock;
    const bool is_work = settling_is_work(a, b, result);
    const Clock::time_point start = is_work ? Clock::now() : Clock::time_point();
    const SettleStatistics work = settle_class(a, b, scenario, query, result, options);
    if (!is_work) {
        return {0, 0, work};
    }
    return {1, std::chrono::duration<double>(Clock::now() - start).count(), work};
}

} // namespace cd
