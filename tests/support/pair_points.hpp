// The shared points of one pair, for tests.
#pragma once

#include "common/pair/triangle_pair.hpp"

#include <span>
#include <vector>

namespace cd::tests {

struct PairPoints {
    Vec3 origin;
    std::vector<Vec3> points;
};

[[nodiscard]] inline PairPoints
points_of(TrianglePairTest& test, const Corners& a, const Corners& b) {
    PairPoints found;
    const PairCorners pair{a, b};
    test.shared_points({&pair, 1}, [&](const Vec3& origin, std::span<const Vec3> points) {
        found = {origin, {points.begin(), points.end()}};
    });
    return found;
}

} // namespace cd::tests
