// Simpler poses under which pairs of triangles meet as under the given ones.
#pragma once

#include "common/geometry/pose.hpp"

namespace cd {

/// True when the linear part, exactly, only permutes and mirrors axes; so for a quarter turn given
/// as a quaternion of two equal components.
[[nodiscard]] bool permutes_axes(const Pose& pose);

/// True when the linear part is a quaternion's, or a matrix, of whole numbers of at most twelve
/// digits, in some unit: then corners in the world are integers little longer than those given.
[[nodiscard]] bool is_short(const Pose& pose);

/// Poses under which every two triangles have the class that they have under `poses`, exactly:
/// one pose for both bodies is none, and one short rotation for both is none where that leaves a
/// translation in doubles; whole translations are taken together where their difference
/// is a double, and if A only has its axes permuted then B bears that as well, where it is no more
/// than that for B either.
[[nodiscard]] PosePair plain_poses(const PosePair& poses);

} // namespace cd
