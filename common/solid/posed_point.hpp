// A point of one body in the coordinates of another, rounded, with an error bound.
#pragma once

#include "common/geometry/pose.hpp"

namespace cd {

struct RoundedPoint {
    Vec3 value;
    double error = 0; ///< Bounds the error of each component; not finite where numbers overflow.
};

[[nodiscard]] inline RoundedPoint posed(const RelativePose& pose, const Vec3& point) {
    constexpr double unit_roundoff = 0x1p-53;
    const double size = point.cwiseAbs().sum();
    const double largest = pose.rotation.cwiseAbs().maxCoeff();
    // Three products and three sums round; the factor is twice the first-order bound.
    return {pose.rotation * point + pose.translation,
            1.01 * (pose.rotation_error * size + pose.translation_error) +
                8 * unit_roundoff * (largest * size + pose.translation.cwiseAbs().maxCoeff()) +
                0x1p-1000};
}

} // namespace cd
