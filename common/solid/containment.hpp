// Whether a part of one closed body lies inside another.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/solid/inside_probes.hpp"
#include "common/solid/point_in_solid.hpp"
#include "common/tree/obb_tree.hpp"

namespace cd {

/// True when some of the probes, which are of `inner`, lies strictly in the solid that what they
/// meet of `outer` bounds, by the parity of a ray's crossings. Meant for bodies of which nothing
/// that meets touches. `outer` must be closed. Exact under the poses as given; never wrong through
/// rounding. Adds what it costs; who knows that the bodies' boxes are apart need not ask.
[[nodiscard]] bool contains_component(const ObbTree& outer,
                                      const Pose& outer_pose,
                                      const ObbTree& inner,
                                      const Pose& inner_pose,
                                      const InsideProbes& probes,
                                      SettleStatistics& statistics);

} // namespace cd
