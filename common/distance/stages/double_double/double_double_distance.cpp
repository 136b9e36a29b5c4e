#include "common/distance/stages/double_double/double_double_distance.hpp"

#include <algorithm>
#include <cmath>

namespace cd {

namespace {

/// Returns a number that is at most `value - error`, or at least that for a negative error. Two
/// roundings, of at most u (u |high| + |error|), are covered by the margin.
double beyond(const DoubleDouble& value, double error) {
    const double margin = 1.01 * error + std::copysign(0x1p-104, error) * std::abs(value.high);
    return value.high + (value.low - margin);
}

} // namespace

DoubleDoubleDistance::DoubleDoubleDistance(const PosePair& poses, double error_scale)
    : a_(poses.a), b_(poses.b), scale_(error_scale) {}

DistanceBounds<DoubleDouble> DoubleDoubleDistance::bounds(const Corners& a,
                                                          const Corners& b,
                                                          const Vec3& near_a,
                                                          std::size_t feature) const {
    distance_certificate::SixCorners<DoubleDouble> corners;
    double magnitude = 0;
    const auto place = [&](const LocalMap& map, const Corners& given, std::size_t first) {
        const Vec3 offset = map.translation - near_a;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[first + i] = map.place(given[i], near_a);
            magnitude = std::max(magnitude, map.magnitude_of(given[i], offset));
        }
    };
    place(a_, a, 0);
    place(b_, b, 3);
    if (!(magnitude >= local_length_least && magnitude <= local_length_most)) {
        return {};
    }
    return certified_bounds(
        corners, feature, {local_error(magnitude), double_double_error, scale_});
}

std::optional<bool> is_within(const DistanceBounds<DoubleDouble>& bounds, double d) {
    if (!bounds.are_proven) {
        return std::nullopt;
    }
    // Adds the rounding error of `bound - d`, which is relative to the sum of both magnitudes.
    const double error =
        bounds.error + 1.01 * double_double_error * (std::abs(bounds.lower.high) + d);
    if (beyond(bounds.lower - DoubleDouble{d, 0}, error) > 0) {
        return false;
    }
    const double upper_error = bounds.error + 1.01 * double_double_error * (bounds.upper.high + d);
    return beyond(bounds.upper - DoubleDouble{d, 0}, -upper_error) <= 0 ? std::optional(true)
                                                                        : std::nullopt;
}

std::optional<double> rounded(const DistanceBounds<DoubleDouble>& bounds) {
    if (!bounds.are_proven) {
        return std::nullopt;
    }
    const double least = beyond(bounds.lower, bounds.error);
    const double greatest = most_rounded(bounds);
    return least == greatest ? std::optional(least) : std::nullopt;
}

double most_rounded(const DistanceBounds<DoubleDouble>& bounds) {
    return beyond(bounds.upper, -bounds.error);
}

} // namespace cd
