// Boxes and poses at the brink: frames as far from orthonormal, and matrices as far from rigid, as
// they may be, and boxes that touch in one point but for a few roundings.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/tree/obb_tree.hpp"

#include <random>

namespace cd::tests {

/// Three directions in floats, off from orthonormal by nearly what a valid node may be.
[[nodiscard]] std::array<float, 9> crooked_axes(std::mt19937_64& random);

/// A valid node: crooked axes, half sizes around `size`, some far smaller, the centre within
/// `offset`.
[[nodiscard]] ObbNode crooked_node(std::mt19937_64& random, double size, double offset);

/// The identity, an exact axis rotation, a quaternion of any norm near 1, a rounded matrix or a
/// matrix whose |R'R - I| is up to 2^-13; the translation within `offset`.
[[nodiscard]] Pose any_pose(std::mt19937_64& random, double offset);

/// The same pose with another translation.
[[nodiscard]] Pose with_translation(const Pose& pose, const Vec3& translation);

/// The pose of B that puts a point of its box (a corner, a point of an edge or of a face) where one
/// of A's box is, from outside, but for roundings.
[[nodiscard]] PosePair
touching_poses(std::mt19937_64& random, const ObbNode& a, const ObbNode& b, double offset);

} // namespace cd::tests
