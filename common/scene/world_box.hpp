// Axis-aligned boxes of posed bodies in the world, in floats that are rounded outward.
#pragma once

#include "common/geometry/aabb.hpp"
#include "common/geometry/pose.hpp"

#include <array>

namespace cd {

/// A closed box, which may be infinite; never NaN.
struct WorldBox {
    std::array<float, 3> low{};
    std::array<float, 3> high{};

    friend bool operator==(const WorldBox&, const WorldBox&) = default;
};

/// Returns a box that contains all points of the world which are at most `margin` away from a point
/// of `body` under the pose. `body` is not empty. Where numbers overflow, the box is infinite.
///
/// The box is that of the posed box, not of the posed vertices: |R| h about R c + t. `error_scale`
/// multiplies the bounds of rounding errors: a smaller scale than 1 lets tests show that they are
/// needed.
[[nodiscard]] WorldBox
world_box(const Aabb& body, const Pose& pose, double margin = 0, double error_scale = 1);

} // namespace cd
