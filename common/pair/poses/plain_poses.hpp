// Finds simpler poses under which all pairs of triangles have the same class.
#pragma once

#include "common/geometry/pose.hpp"

namespace cd {

/// Tests whether the linear part exactly permutes and mirrors axes, as a quarter turn does that is
/// given as a quaternion with two equal components.
[[nodiscard]] bool permutes_axes(const Pose& pose);

/// Tests whether the quaternion or matrix consists of whole numbers of at most twelve binary
/// digits, in some unit. World corners are then integers little longer than the given ones.
[[nodiscard]] bool is_short(const Pose& pose);

/// Returns simpler poses under which every two triangles have exactly the same class. Removes a
/// pose that both bodies have, and a short rotation that both have if doubles hold the remaining
/// translation. Moves A's translation into B's if the difference is a double. If both poses only
/// permute and mirror axes, moves A's permutation into B's pose.
[[nodiscard]] PosePair plain_poses(const PosePair& poses);

} // namespace cd
