// Decides whether a part of one closed body lies inside another.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/solid/inside_probes.hpp"
#include "common/solid/point_in_solid.hpp"
#include "common/tree/obb_tree.hpp"

namespace cd {

/// Returns true when some probe, a point of `inner`, lies strictly in the solid that is bounded by
/// those triangles of `outer` that are not left out for it, by the parity of a ray's crossings. The
/// bodies do not touch in any pair that is not ignored, and `outer` is closed. The answer is exact
/// under the given poses. Adds the cost to the statistics. A caller that knows that the bodies'
/// boxes are apart can skip the call.
[[nodiscard]] bool contains_component(const ObbTree& outer,
                                      const Pose& outer_pose,
                                      const ObbTree& inner,
                                      const Pose& inner_pose,
                                      const InsideProbes& probes,
                                      SettleStatistics& statistics);

} // namespace cd
