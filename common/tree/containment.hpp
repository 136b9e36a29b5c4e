// Whether a part of one closed body lies inside another.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/point_in_solid.hpp"

namespace cd {

/// True when some connected component of `inner` lies strictly in the solid that `outer` bounds, by
/// the parity of a ray's crossings. Meant for bodies whose surfaces share no point, so one corner
/// of each component decides. `outer` must be closed. Exact under the poses as given; never wrong
/// through rounding. Costs nothing while the bodies' boxes are apart; adds what it costs else.
[[nodiscard]] bool contains_component(const ObbTree& outer,
                                      const Pose& outer_pose,
                                      const ObbTree& inner,
                                      const Pose& inner_pose,
                                      SettleStatistics& statistics);

} // namespace cd
