// How far apart, in a body's own coordinates, two points can be that are near each other in the
// world.
#pragma once

#include "common/geometry/pose.hpp"

namespace cd {

/// Returns a length r such that two points which are at most `distance` apart in the world are at
/// most r apart in the coordinates of A and in those of B. A quaternion keeps lengths; a matrix may
/// change them. Infinite if a matrix may map a vector to almost nothing, or if numbers overflow.
[[nodiscard]] double body_reach(const PosePair& poses, double distance);

} // namespace cd
