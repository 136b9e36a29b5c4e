#include "common/job/settle.hpp"

#include "common/tree/containment.hpp"

namespace cd {

namespace {

bool are_closed(const ObbTree& a, const ObbTree& b) {
    return a.topology().is_closed() && b.topology().is_closed();
}

} // namespace

bool settling_is_work(const ObbTree& a, const ObbTree& b, const ScenarioResult& result) {
    return result.level >= Level::Count && result.kind == ScenarioClass::Separate &&
           are_closed(a, b);
}

SettleStatistics settle_class(const ObbTree& a,
                              const ObbTree& b,
                              const Scenario& scenario,
                              const Query& query,
                              ScenarioResult& result) {
    result.surfaces_only = result.kind != ScenarioClass::Failed && !are_closed(a, b);
    // An ignored part that sticks in the other body would be "inside" it in every scenario.
    if (!settling_is_work(a, b, result) || !query.ignored.empty()) {
        return {};
    }
    SettleStatistics statistics;
    const PosePair& poses = scenario.poses;
    if (contains_component(a, poses.a, b, poses.b, statistics) ||
        contains_component(b, poses.b, a, poses.a, statistics)) {
        result.kind = ScenarioClass::Inside;
    }
    return statistics;
}

} // namespace cd
