// How far apart two points can be in a body's coordinates if they are near each other in the world,
// and the other way round.
#pragma once

#include "common/geometry/pose.hpp"

namespace cd {

/// Returns a length r such that two points which are at most `distance` apart in the world are at
/// most r apart in the coordinates of A and in those of B. A quaternion keeps lengths; a matrix may
/// change them. Infinite if a matrix may map a vector to almost nothing, or if numbers overflow.
[[nodiscard]] double body_reach(const PosePair& poses, double distance);

/// Returns an upper bound on the distance in the world of two points that are at most `distance`
/// apart in the coordinates of a body with this pose.
[[nodiscard]] double world_reach(const Pose& pose, double distance);

} // namespace cd
