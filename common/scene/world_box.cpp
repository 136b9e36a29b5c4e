// Why the box contains the body. Write [c - h, c + h] for a box in the body's coordinates that
// contains `body`, R* for the exact rotation and R for the computed one, whose entries err by at
// most e (`Pose::rotation_error`). A point of the body is c + d with |d_k| <= h_k, and its world
// coordinate is
//     (R* (c + d) + t)_i = (R c + t)_i + (R d)_i + ((R* - R) (c + d))_i.
// The second term is at most sum_k |R_ik| h_k, and the third at most e (|c|_1 + |h|_1). With u =
// 2^-53, the computed centre errs by at most 4 u (sum_k |R_ik| |c_k| + |t_i|), a sum of four terms
// three of which are products; the computed radius by at most 4 u times itself. The bounds below
// have twice these, which also covers the rounding of the bounds. h is the larger distance from the
// computed c to the two faces, rounded up. A point at most `margin` away adds that much to
// each coordinate. Products that underflow lose less than the least normal double.
#include "common/scene/world_box.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cd {

namespace {

constexpr double roundoff = 0x1p-53;

/// Returns the next float below a finite one.
float next_below(float value) {
    if (value == 0) {
        return -std::numeric_limits<float>::denorm_min();
    }
    const auto bits = std::bit_cast<std::int32_t>(value);
    return std::bit_cast<float>(value > 0 ? bits - 1 : bits + 1);
}

/// Returns the greatest float that is at most `value`; minus infinity for NaN.
float float_below(double value) {
    constexpr float largest = std::numeric_limits<float>::max();
    if (!(value >= -double{largest})) {
        return -std::numeric_limits<float>::infinity();
    }
    if (value > double{largest}) {
        return largest;
    }
    const auto nearest = static_cast<float>(value);
    return double{nearest} <= value ? nearest : next_below(nearest);
}

/// Returns a bound on the distance from `center` to both numbers.
double half_size(double low, double high, double center) {
    return (1 + 4 * roundoff) * std::max(high - center, center - low) +
           std::numeric_limits<double>::denorm_min();
}

} // namespace

WorldBox world_box(const Aabb& body, const Pose& pose, double margin, double error_scale) {
    const Mat3 rotation = pose.rotation();
    const Vec3 center = body.center();
    const Vec3 half(half_size(body.min.x(), body.max.x(), center.x()),
                    half_size(body.min.y(), body.max.y(), center.y()),
                    half_size(body.min.z(), body.max.z(), center.z()));
    const double size = center.lpNorm<1>() + half.lpNorm<1>();
    WorldBox box;
    for (int i = 0; i < 3; ++i) {
        const auto row = rotation.row(i);
        const double middle = row.dot(center) + pose.translation()[i];
        const double radius = row.cwiseAbs().dot(half);
        const double largest = row.cwiseAbs().dot(center.cwiseAbs()) +
                               std::abs(pose.translation()[i]) + radius + margin;
        const double error = 8 * roundoff * largest + 2 * pose.rotation_error() * size +
                             std::numeric_limits<double>::min();
        const double reach = radius + error_scale * error + margin;
        box.low[static_cast<std::size_t>(i)] = float_below(middle - reach);
        box.high[static_cast<std::size_t>(i)] = -float_below(-(middle + reach));
    }
    return box;
}

} // namespace cd
