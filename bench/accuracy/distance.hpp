// Reference distances in doubles, accurate to a few roundings.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/tree/obb_tree.hpp"

namespace cd::bench {

/// Returns the distance of two separate bodies in the world, under rigid poses.
[[nodiscard]] double distance_of_bodies(const ObbTree& a, const ObbTree& b, const PosePair& poses);

} // namespace cd::bench
