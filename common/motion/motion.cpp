#include "common/motion/motion.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"

#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

Result<unsigned> depth_for(double bound, double resolution) {
    for (unsigned depth = 0; depth <= limits::motion_depth_max; ++depth) {
        if (std::ldexp(bound, -static_cast<int>(depth)) <= resolution) {
            return depth;
        }
    }
    return Error{ErrorCode::TooLarge,
                 "the bodies move too far between two keys for this resolution; insert keys, or "
                 "raise the resolution"};
}

Result<unsigned>
motion_depth(const PosePair& from, const PosePair& to, const BodyRadii& radii, double resolution) {
    if (!(resolution > 0) || !std::isfinite(resolution)) {
        return bad_input("the resolution of a motion is a positive length");
    }
    const BodyPath a = CD_TRY(path_between(from.a, to.a));
    const BodyPath b = CD_TRY(path_between(from.b, to.b));
    return depth_for(cell_bound(a, b, radii, {}, infinity), resolution);
}

Result<Motion> Motion::create(const PosePair& from,
                              const PosePair& to,
                              const BodyRadii& radii,
                              double resolution) {
    const unsigned depth = CD_TRY(motion_depth(from, to, radii, resolution));
    const BodyPath a = CD_TRY(path_between(from.a, to.a));
    const BodyPath b = CD_TRY(path_between(from.b, to.b));
    if (!has_exact_poses(a, depth + 1) || !has_exact_poses(b, depth + 1)) {
        return bad_input("the keys of a motion have too many digits for exact poses between them");
    }
    return Motion(a, b, radii, resolution, depth);
}

PosePair Motion::at(std::uint32_t index, unsigned level) const {
    CD_CHECK(level <= depth_ + 1);
    const double tau = std::ldexp(static_cast<double>(index), -static_cast<int>(level));
    return {pose_at(a_, tau), pose_at(b_, tau)};
}

PosePair Motion::at_middle(const TimeCell& cell) const {
    return at(2 * cell.index + 1, cell.level + 1);
}

double Motion::bound() const {
    return bound({}, infinity);
}

} // namespace cd
