// The nearest points of two bodies, as files and pictures show them.
#pragma once

#include "common/job/result/result.hpp"

#include <array>

namespace cd {

/// Returns the nearest points of A and B in the world, in the job's unit. Each is rounded once, so
/// their distance may differ from the witness's in the last digits.
[[nodiscard]] inline std::array<Vec3, 2> witness_points(const NearestWitness& nearest) {
    return {Vec3(nearest.origin + nearest.point_a), Vec3(nearest.origin + nearest.point_b)};
}

/// Makes a result with a distance one that lists its nearest pair as a near pair at `level
/// contacts`, so that what draws near pairs draws it. A result without a distance stays as it is.
inline void list_witness(ScenarioResult& result) {
    if (!result.nearest) {
        return;
    }
    const NearestWitness& nearest = *result.nearest;
    result.level = Level::Contacts;
    result.near_count = 1;
    result.pairs = {{nearest.a, nearest.b, PairClass::Near}};
    result.point_origins = {nearest.origin};
    result.point_offsets = {0, 2};
    result.points = {nearest.point_a, nearest.point_b};
    result.near_distances = {nearest.distance};
}

} // namespace cd
