// Bounds, with e for `double_double_error`.
//
// Depth: with s and t for the sides of p and q, each of which errs by at most ds, the share
// s / (s - t) errs by
//     |s / (s - t) - s' / (s' - t')| = |s' (t - t') - t' (s - s')| / (|s - t| |s' - t'|)
//                                   <= ds / |s - t|,
// as the true sides s' and t' have different signs or one is 0. The computed difference errs by
// e |s - t| besides, the quotient by 2 e and the product with the length by e, all relatively: 4 e
// of a share that is at most 1 but for its error. So the depth errs by at most 1.2 ds / |s - t| +
// 8 e times the length, with room for terms of higher order.
//
// Ends in A's coordinates, R'y for y = x' - t_a and A's rotation R: let M bound the sum of the
// magnitudes in a component of y, which errs by 20 e M (`local_error`). R's entries are at most 1
// and err by 10 e, a column's magnitudes sum to at most 1.74, and those of y to 3 M. Three products
// err by e, and two sums: 1.74 * 20 e M + 13 e * 3 M = 74 e M, so h = 80 e M has room.
//
// Sides in A's coordinates: the edges are exact, as sums of two doubles. Let X bound their
// components, Z those of the ends and the corner, and W those of the differences w of ends and
// corner; w errs by h + 2 e Z. A component of the normal n is at most 2 X^2, and errs by 4 e X^2.
// Each of three products in n.w errs by 2 X^2 (h + 2 e Z) + 4 e X^2 W + 2 e X^2 W, and the two sums
// by 10 e X^2 W in all: X^2 (6 h + 12 e Z + 28 e W). X^2 (8 h + 16 e Z + 36 e W) has room for terms
// of higher order and the bound's own roundings. With X, M and Z from 2^-200 to 2^200, underflow
// loses a few multiples of 2^-1074 W, while the bound is above 2^-500 W.
//
// Sides in the world, where A's pose is a matrix: LocalHalf has the bounds.
#include "common/shots/stages/double_double/double_double_depth.hpp"

#include "common/pair/stages/double_double/double_double_places.hpp"
#include "common/shots/rigid_pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double e = double_double_error;

bool is_in_range(double length) {
    return length >= local_length_least && length <= local_length_most;
}

double largest_of(const DoubleDoubleVec& v) {
    return std::max({std::abs(v[0].high), std::abs(v[1].high), std::abs(v[2].high)});
}

DoubleDoubleVec exact_difference(const Vec3& l, const Vec3& r) {
    return {exact_sum(l.x(), -r.x()), exact_sum(l.y(), -r.y()), exact_sum(l.z(), -r.z())};
}

DoubleDoubleVec cross(const DoubleDoubleVec& l, const DoubleDoubleVec& r) {
    return {l[1] * r[2] - l[2] * r[1], l[2] * r[0] - l[0] * r[2], l[0] * r[1] - l[1] * r[0]};
}

} // namespace

DoubleDoubleDepth::DoubleDoubleDepth(const PosePair& poses, double bound_scale)
    : a_(poses.a), b_(poses.b), bound_scale_(bound_scale), is_in_frame_(is_rigid(poses.a)) {}

void DoubleDoubleDepth::set_line(const Segment& line, double length) {
    length_ = length;
    is_in_frame_ ? place_in_frame(line) : place_in_world(line);
}

void DoubleDoubleDepth::place_in_frame(const Segment& line) {
    const Vec3 offset = b_.translation - a_.translation;
    const std::array<Vec3, 2> given{line.p, line.q};
    double magnitude = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const DoubleDoubleVec y = b_.place(given[i], a_.translation);
        magnitude = std::max(magnitude, b_.magnitude_of(given[i], offset));
        for (std::size_t k = 0; k < 3; ++k) {
            ends_[i][k] = a_.rows[0][k] * y[0] + a_.rows[1][k] * y[1] + a_.rows[2][k] * y[2];
        }
    }
    end_error_ = is_in_range(magnitude) ? 80 * e * magnitude * bound_scale_
                                        : std::numeric_limits<double>::infinity();
}

void DoubleDoubleDepth::place_in_world(const Segment& line) {
    const DoubleDoubleVec from = b_.place(line.p, Vec3::Zero());
    origin_ = Vec3(from[0].high, from[1].high, from[2].high);
    line_.reset();
    if (origin_.allFinite()) {
        line_.emplace(b_, line.corners(), origin_);
    }
}

std::optional<DoubleDoubleDepth::Sides> DoubleDoubleDepth::sides_in_frame(const Corners& a) const {
    const DoubleDoubleVec u = exact_difference(a[1], a[0]);
    const DoubleDoubleVec v = exact_difference(a[2], a[0]);
    const DoubleDoubleVec normal = cross(u, v);
    const DoubleDoubleVec corner{
        DoubleDouble{a[0].x(), 0}, DoubleDouble{a[0].y(), 0}, DoubleDouble{a[0].z(), 0}};
    const DoubleDoubleVec from = ends_[0] - corner;
    const DoubleDoubleVec to = ends_[1] - corner;
    const double x = 1.01 * std::max(largest_of(u), largest_of(v));
    const double z =
        1.01 * std::max({largest_of(ends_[0]), largest_of(ends_[1]), largest_of(corner)});
    if (!(is_in_range(x) && is_in_range(z) && end_error_ <= local_length_most)) {
        return std::nullopt;
    }
    const double end_error = end_error_ + 2 * e * z * bound_scale_;
    const double w = 1.01 * std::max(largest_of(from), largest_of(to)) + 2 * end_error;
    const double error = x * x * (8 * end_error + 36 * e * w * bound_scale_);
    return Sides{dot(normal, from), dot(normal, to), error};
}

std::optional<DoubleDoubleDepth::Sides> DoubleDoubleDepth::sides_in_world(const Corners& a) const {
    if (!line_) {
        return std::nullopt;
    }
    const LocalTriangle triangle(a_, a, origin_);
    if (!is_in_range(std::max(triangle.magnitude, line_->magnitude))) {
        return std::nullopt;
    }
    const LocalHalf half(*line_, triangle, LocalBounds(triangle, *line_, bound_scale_));
    return half.side_error >= side_error_least * bound_scale_
               ? std::optional(Sides{half.sides[0], half.sides[1], half.side_error})
               : std::nullopt;
}

std::optional<double> DoubleDoubleDepth::depth(const Corners& a) const {
    const std::optional<Sides> sides = is_in_frame_ ? sides_in_frame(a) : sides_in_world(a);
    if (!sides || !is_in_range(length_)) {
        return std::nullopt;
    }
    const DoubleDouble apart = sides->of_p - sides->of_q;
    const double size = std::abs(apart.high);
    if (!(size > 4 * sides->error)) {
        return std::nullopt;
    }
    LocalBounds bounds;
    bounds.scale = bound_scale_;
    const DoubleDouble depth = sides->of_p / apart * length_;
    return rounded(depth, length_ * (1.2 * sides->error / size + 8 * e * bound_scale_), bounds);
}

} // namespace cd
