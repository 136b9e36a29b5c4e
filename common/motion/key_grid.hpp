// The grid of a motion's keys, on which poses between two keys are doubles.
#pragma once

#include "common/geometry/pose.hpp"

namespace cd {

/// Numbers that keys may have. Components of quaternions are multiples of 2^(bits - 52), at most 1
/// in magnitude; coordinates of positions are multiples of 2^(exponent + bits - 52), at most
/// 2^exponent in magnitude. Then (1 - tau) x + tau y of two such numbers is a double, without any
/// rounding, wherever tau is a multiple of 2^-bits: as an integer it has at most 52 bits.
struct KeyGrid {
    unsigned bits = 1;
    int exponent = exponent_min;

    /// Positions may be 0, but their grid is no finer than this exponent makes it, so that products
    /// of keys' numbers do not underflow.
    static constexpr int exponent_min = -400;

    /// Tests whether a pose of kind Quaternion is on the grid.
    [[nodiscard]] bool holds(const Pose& key) const;

    /// Returns the pose of kind Quaternion on the grid that is nearest to the key in each number.
    /// The key's numbers are finite and no greater than the grid's greatest.
    [[nodiscard]] Pose rounded(const Pose& key) const;
};

/// Returns the least exponent of a grid for a key with this position, which is finite.
[[nodiscard]] int grid_exponent(const Vec3& position);

} // namespace cd
