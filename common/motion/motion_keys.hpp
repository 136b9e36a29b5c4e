// Turns the poses that a user gives as keys into keys on a grid.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/pose.hpp"
#include "common/motion/motion_bound.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// A matrix whose distance from its rounded rotation (Frobenius norm) exceeds this is no key.
inline constexpr double key_matrix_off_max = 0x1p-10;

/// Returns the key with a quaternion of norm 1, within roundings. A matrix becomes the quaternion
/// of nearly the same rotation. Errors: BadInput for a matrix that is no rotation within
/// `key_matrix_off_max`, and for numbers that are not finite.
[[nodiscard]] Result<Pose> unit_key(const Pose& given);

/// Bounds how far a point of a body moves if its pose `given` becomes the key `rounded`.
[[nodiscard]] double moved_at_most(const Pose& given, const Pose& rounded, double radius);

/// Keys from which motions are made, and what the rounding has changed.
struct RoundedKeys {
    std::vector<PosePair> keys; ///< All of kind Quaternion, on one grid.
    unsigned bits = 0;          ///< The grid's: 1 + the largest depth of a motion between two keys.
    /// No point of A, or of B, is farther from where a given key puts it, in the job's unit.
    BodyRadii moved;
};

/// Names a key in errors, from its number from 0: "line 7".
using NameKey = std::function<std::string(std::size_t key)>;

/// Returns "key 3".
[[nodiscard]] std::string name_of_key(std::size_t key);

/// Rounds keys once, so that motions from each to the next have exact poses (KeyGrid). Matrices
/// become the quaternions of nearly the same rotation. Depends on the arguments alone.
///
/// `radii` and `resolution` are those of the motions (`Motion::create`). Errors begin with the name
/// of the key, or of the later of two: BadInput for a matrix that is no rotation within
/// `key_matrix_off_max` and for numbers that are not finite; those of `Motion::create`.
[[nodiscard]] Result<RoundedKeys> round_keys(std::span<const PosePair> given,
                                             const BodyRadii& radii,
                                             double resolution,
                                             const NameKey& name = name_of_key);

} // namespace cd
