// Results of a query with a clearance, for tests of what users see.
#pragma once

#include "common/job/result/result.hpp"

#include <vector>

namespace cd::tests {

namespace support {

inline ScenarioResult near_scenario() {
    ScenarioResult near;
    near.index = 1;
    near.kind = ScenarioClass::Near;
    near.near_count = 2;
    near.pairs = {{0, 5, PairClass::Near}, {7, 2, PairClass::Near}};
    near.point_origins = {{10, 0, 0}, {20, 0, 0}};
    near.point_offsets = {0, 2, 4};
    near.points = {{0, 0, 0}, {0, 0, 0.125}, {0, 0, 0}, {0.25, 0, 0}};
    near.near_distances = {0.125, 0.25};
    return near;
}

inline ScenarioResult touching_scenario() {
    ScenarioResult touch;
    touch.index = 2;
    touch.kind = ScenarioClass::Touch;
    touch.pair_count = 1;
    touch.near_count = 3;
    touch.pairs = {{0, 4, PairClass::Touch}, {0, 5, PairClass::Near}};
    touch.point_origins = {{1, 2, 3}, {0, 0, 0}};
    touch.point_offsets = {0, 1, 3};
    touch.points = {{0, 0, 0}, {0, 0, 0}, {0, 0.0625, 0}};
    touch.near_distances = {0.0625};
    return touch;
}

/// Removes what results of a lower level do not have.
inline void lower(ScenarioResult& result, Level level) {
    result.level = level;
    if (level < Level::Contacts) {
        result.point_origins = {};
        result.point_offsets = {};
        result.points = {};
        result.near_distances = {};
    }
    if (level < Level::Pairs) {
        result.pairs = {};
    }
    if (level == Level::Any) {
        result.kind = result.kind == ScenarioClass::Touch ? ScenarioClass::Contact : result.kind;
        result.pair_count = 0;
        result.near_count = 0;
    }
}

} // namespace support

/// Returns results of a query with a clearance at this level: scenario 0 is separate; 1 has two
/// near pairs; 2 has a touching pair and three near ones, of which the list has one.
inline std::vector<ScenarioResult> near_results(Level level) {
    ScenarioResult separate;
    separate.point_offsets = {0};
    std::vector<ScenarioResult> results{
        separate, support::near_scenario(), support::touching_scenario()};
    for (ScenarioResult& result : results) {
        result.has_clearance = true;
        support::lower(result, level);
    }
    return results;
}

} // namespace cd::tests
