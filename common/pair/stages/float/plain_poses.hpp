// Finds simpler poses under which all pairs of triangles have the same class.
#pragma once

#include "common/geometry/pose.hpp"

namespace cd {

/// True if the linear part exactly permutes and mirrors axes, as a quarter turn given as a
/// quaternion of two equal components does.
[[nodiscard]] bool permutes_axes(const Pose& pose);

/// True if the linear part is a quaternion or matrix of whole numbers of at most twelve digits, in
/// some unit. World corners are then integers little longer than the given ones.
[[nodiscard]] bool is_short(const Pose& pose);

/// Returns poses that exactly preserve the class of every two triangles. A pose common to both
/// bodies is removed, and so is a common short rotation if doubles hold the remaining translation.
/// Translations are merged into B's if their difference is a double. If both poses only permute
/// axes, B takes over A's permutation.
[[nodiscard]] PosePair plain_poses(const PosePair& poses);

} // namespace cd
