// Boxes of moving bodies in the world.
#pragma once

#include "common/geometry/aabb.hpp"
#include "common/motion/body_path.hpp"
#include "common/scene/world_box.hpp"

namespace cd {

/// The path of a body of a scene, and its mesh's box and radius in its own coordinates.
struct MovingBody {
    Aabb box; ///< Not empty.
    double radius = 0;
    BodyPath path; ///< Has exact poses at tau = 1/2.
};

/// Returns a box that contains, at every time of the path, all points of the world which are at
/// most `margin` away from a point of the body's triangles. It also contains those that are at most
/// M / 2^15 farther away, where M is the body's part in the bound of the whole motion (see
/// `reach_of_motions`). Where numbers overflow, the box is infinite.
///
/// It is the box of the posed box at tau = 1/2, grown by `movement_bound`: no vertex is ever
/// farther from where it is at that time, so no point of a triangle is.
[[nodiscard]] WorldBox swept_box(const MovingBody& body, double margin);

/// Returns how far apart bodies may come in a motion whose result says more than that they are
/// separate, in the job's unit, beside M / 2^15 of that motion.
///
/// Open parts are where the bodies are within the clearance and the resolution of each other. If
/// they never are, the search can still end early, with more cells than a search may test, where
/// they slide along each other. But cells of level 15 are free if the bodies are farther apart than
/// M / 2^15 and the clearance, and there are fewer than that many cells up to this level.
[[nodiscard]] double reach_of_motions(double clearance, double resolution);

} // namespace cd
