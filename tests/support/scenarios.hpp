// Scenarios and queries of tests.
#pragma once

#include "common/job/query.hpp"
#include "common/job/scenario.hpp"
#include "tests/support/shapes.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace cd::tests {

inline constexpr std::array<Level, 4> levels{
    Level::Any, Level::Count, Level::Pairs, Level::Contacts};

[[nodiscard]] inline Scenario make_scenario(const PosePair& poses, std::uint64_t index = 0) {
    Scenario scenario;
    scenario.index = index;
    scenario.poses = poses;
    return scenario;
}

/// Makes scenarios of random poses of B, with the indices from 0.
[[nodiscard]] inline std::vector<Scenario> numbered_scenarios(std::uint64_t count) {
    std::mt19937_64 random(5);
    std::vector<Scenario> scenarios;
    for (std::uint64_t i = 0; i < count; ++i) {
        scenarios.push_back(make_scenario({Pose{}, make_pose(random, 3)}, i));
    }
    return scenarios;
}

[[nodiscard]] inline Query query_of(Level level, std::uint64_t limit_pairs = 0) {
    Query query;
    query.level = level;
    query.limit_pairs = limit_pairs;
    return query;
}

} // namespace cd::tests
