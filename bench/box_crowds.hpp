// Many posed boxes that move, for benchmarks of the broad phase.
#pragma once

#include "common/geometry/aabb.hpp"
#include "common/geometry/pose.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace cd::bench {

struct PosedBox {
    Aabb box;
    Pose pose; ///< Of kind Quaternion.
};

/// Returns `count` cars on a square, 10 m apart on average, each along x or y, or turned by a few
/// degrees.
[[nodiscard]] std::vector<PosedBox> make_town(std::size_t count);

/// Returns `count` turned parts, of sizes from 1 to 30 cm, in a cube that they fill eight times
/// over.
[[nodiscard]] std::vector<PosedBox> make_assembly(std::size_t count);

/// Returns the poses of the boxes at each of some steps, the first of which has those given. Each
/// box moves by a constant random amount a step, of up to `move` along each axis of the world, and
/// turns about z by up to `turn` rad.
[[nodiscard]] std::vector<std::vector<Pose>>
moving_poses(const std::vector<PosedBox>& boxes, std::size_t steps, const Vec3& move, double turn);

} // namespace cd::bench
