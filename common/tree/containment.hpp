// Whether a point lies inside a closed mesh: exact parity.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/tree/obb_tree.hpp"

namespace cd {

/// True when some connected component of `inner` lies strictly in the solid that `outer` bounds, by
/// the parity of a ray's crossings. Meant for bodies whose surfaces share no point, so one corner
/// of each component decides. `outer` must be closed. Exact under the poses as given; never wrong
/// through rounding. Costs nothing while the bodies' boxes are apart.
[[nodiscard]] bool contains_component(const ObbTree& outer,
                                      const Pose& outer_pose,
                                      const ObbTree& inner,
                                      const Pose& inner_pose);

} // namespace cd
