// Boxes and poses at the limits of validity: frames as far from orthonormal and matrices as far
// from rigid as allowed, and boxes that touch in one point up to a few roundings.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/tree/obb_tree.hpp"

#include <random>

namespace cd::tests {

/// Three float axes, nearly as far from orthonormal as a valid node allows.
[[nodiscard]] std::array<float, 9> crooked_axes(std::mt19937_64& random);

/// Makes a valid node: crooked axes, half sizes around `size` (some far smaller), centre within
/// `offset`.
[[nodiscard]] ObbNode crooked_node(std::mt19937_64& random, double size, double offset);

/// Makes a pose with its translation within `offset`. The rotation is the identity, an exact axis
/// rotation, a quaternion of norm near 1, a rounded matrix, or a matrix with |R'R - I| up to 2^-13.
[[nodiscard]] Pose any_pose(std::mt19937_64& random, double offset);

/// Returns `pose` with its translation replaced.
[[nodiscard]] Pose with_translation(const Pose& pose, const Vec3& translation);

/// Makes a pair of poses in which a point of B's box (on a corner, edge or face) touches A's box
/// from outside, up to roundings.
[[nodiscard]] PosePair
touching_poses(std::mt19937_64& random, const ObbNode& a, const ObbNode& b, double offset);

} // namespace cd::tests
