// Tells rigid poses from others.
#pragma once

#include "common/geometry/pose.hpp"

namespace cd {

/// Returns whether the pose is exactly a rotation and a translation, as far as its kind tells:
/// rounded matrices are not.
[[nodiscard]] inline bool is_rigid(const Pose& pose) {
    return pose.kind() == Pose::Kind::Quaternion || pose.matrix() == Mat3::Identity();
}

} // namespace cd
