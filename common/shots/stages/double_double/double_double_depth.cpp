// Bounds: with s and t for the sides of p and q, each of which errs by at most ds (LocalHalf), the
// share s / (s - t) errs by
//     |s / (s - t) - s' / (s' - t')| = |s' (t - t') - t' (s - s')| / (|s - t| |s' - t'|)
//                                   <= ds / |s - t|,
// as the true sides s' and t' have different signs or one is 0. With e for `double_double_error`,
// the computed difference errs by e |s - t| besides, the quotient by 2 e and the product with the
// length by e, all relatively: 4 e of a share that is at most 1 but for its error. So the depth
// errs by at most 1.2 ds / |s - t| + 8 e times the length, with room for terms of higher order.
#include "common/shots/stages/double_double/double_double_depth.hpp"

#include "common/pair/stages/double_double/double_double_places.hpp"

#include <cmath>

namespace cd {

DoubleDoubleDepth::DoubleDoubleDepth(const PosePair& poses, double bound_scale)
    : a_(poses.a), b_(poses.b), bound_scale_(bound_scale) {}

void DoubleDoubleDepth::set_line(const Segment& line, double length) {
    const DoubleDoubleVec from = b_.place(line.p, Vec3::Zero());
    origin_ = Vec3(from[0].high, from[1].high, from[2].high);
    length_ = length;
    line_.reset();
    if (origin_.allFinite()) {
        line_.emplace(b_, line.corners(), origin_);
    }
}

std::optional<double> DoubleDoubleDepth::depth(const Corners& a) const {
    if (!line_) {
        return std::nullopt;
    }
    const LocalTriangle triangle(a_, a, origin_);
    const LocalBounds bounds(triangle, *line_, bound_scale_);
    const double magnitude = std::max(triangle.magnitude, line_->magnitude);
    if (!(magnitude >= local_length_least && magnitude <= local_length_most &&
          length_ >= local_length_least && length_ <= local_length_most)) {
        return std::nullopt;
    }
    const LocalHalf half(*line_, triangle, bounds);
    const DoubleDouble apart = half.sides[0] - half.sides[1];
    if (!(half.side_error >= side_error_least * bound_scale_ &&
          std::abs(apart.high) > 4 * half.side_error)) {
        return std::nullopt;
    }
    const DoubleDouble depth = half.sides[0] / apart * length_;
    const double error = length_ * (1.2 * half.side_error / std::abs(apart.high) +
                                    8 * double_double_error * bounds.scale);
    return rounded(depth, error, bounds);
}

} // namespace cd
