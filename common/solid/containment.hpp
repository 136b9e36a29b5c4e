// Decides whether a part of one closed body lies inside another.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/solid/inside_probes.hpp"
#include "common/solid/point_in_solid.hpp"
#include "common/tree/obb_tree.hpp"

namespace cd {

/// Returns true if any probe, a point of `inner`, lies strictly inside the solid that `outer`
/// bounds without the triangles left out for that probe. Counts the crossings of a ray (parity).
/// Requires that `outer` is closed, and that only ignored pairs of triangles touch. The answer is
/// exact under the given poses. Adds the cost to `statistics`. A caller that knows that the bodies'
/// boxes are apart can skip the call.
[[nodiscard]] bool contains_component(const ObbTree& outer,
                                      const Pose& outer_pose,
                                      const ObbTree& inner,
                                      const Pose& inner_pose,
                                      const InsideProbes& probes,
                                      SettleStatistics& statistics);

} // namespace cd
