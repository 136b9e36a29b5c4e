// The path of a body between two keys, and its exact poses.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/pose.hpp"

namespace cd {

/// Returns the scalar product of two quaternions, rounded in one order on every host.
[[nodiscard]] double dot(const Quaternion& l, const Quaternion& r);

/// A rigid path for tau in [0, 1]. The body is turned by q(tau) = (1 - tau) q0 + tau q1, which is
/// not normalised, and its origin is at c(tau) = (1 - tau) c0 + tau c1. This is the path of slerp
/// at a slightly different pace.
struct BodyPath {
    Quaternion q0;
    Quaternion q1;
    Vec3 c0 = Vec3::Zero();
    Vec3 c1 = Vec3::Zero();
};

/// Returns the path from one key to the next, the short way round: q1 is negated if need be. Both
/// are of kind Quaternion and of norm near 1. Errors: BadInput for other keys, numbers that are not
/// finite, and a turn so near to 180 degrees that rounding would choose its direction.
[[nodiscard]] Result<BodyPath> path_between(const Pose& from, const Pose& to);

/// Tests whether `pose_at` is exact wherever tau is a multiple of 2^-bits.
[[nodiscard]] bool has_exact_poses(const BodyPath& path, unsigned bits);

/// Returns the pose at tau, exactly where the path `has_exact_poses`.
[[nodiscard]] Pose pose_at(const BodyPath& path, double tau);

} // namespace cd
