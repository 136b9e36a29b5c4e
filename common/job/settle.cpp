#include "common/job/settle.hpp"

#include "common/tree/containment.hpp"
#include "common/tree/penetration.hpp"

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
                                      SettleStatistics& statistics) {
    ++statistics.searches;
    ContactSearch search(poses, query.ignored);
    search.collect(a.view(), b.view());
    search.sort();
    return std::move(search.pairs());
}

bool is_cross(const ObbTree& a,
              const ObbTree& b,
              const PosePair& poses,
              const Query& query,
              const ScenarioResult& result,
              SettleStatistics& statistics) {
    const bool holds_all = result.pairs.size() == result.pair_count;
    const std::vector<ContactPair> found =
        holds_all ? std::vector<ContactPair>{} : search_again(a, b, poses, query, statistics);
    return penetrates(a, b, poses, holds_all ? result.pairs : found, query.ignored, statistics);
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
                              ScenarioResult& result) {
    result.surfaces_only = result.kind != ScenarioClass::Failed && !are_closed(a, b);
    SettleStatistics statistics;
    if (!settling_is_work(a, b, result)) {
        return statistics;
    }
    if (result.kind == ScenarioClass::Touch) {
        if (is_cross(a, b, scenario.poses, query, result, statistics)) {
            result.kind = ScenarioClass::Cross;
        }
    } else if (query.ignored.empty() && is_inside(a, b, scenario.poses, statistics)) {
        // (An ignored part that sticks in the other body would be "inside" it in every scenario.)
        result.kind = ScenarioClass::Inside;
    }
    return statistics;
}

} // namespace cd
