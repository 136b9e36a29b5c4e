#include "common/scene/swept_box.hpp"

#include "common/core/limits/engine.hpp"
#include "common/motion/motion_bound.hpp"

#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// M of a cell at the level up to which a search tests fewer cells than it may, by M of the whole.
constexpr double bound_of_many_cells = 2.0 / limits::motion_cells_max;

} // namespace

WorldBox swept_box(const MovingBody& body, double margin) {
    const double movement = movement_bound(body.path, body.radius);
    const double grown = (1 + bound_of_many_cells) * movement + margin;
    // Two sums and a product, each of which may be rounded down.
    const double rounded_up = (1 + 0x1p-50) * grown;
    return world_box(body.box, pose_at(body.path, 0.5), rounded_up);
}

double reach_of_motions(double clearance, double resolution) {
    return std::nextafter(clearance + resolution, infinity);
}

} // namespace cd
