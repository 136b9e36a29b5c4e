// Poses applied as the contract defines them, in any number type: a quaternion q rotates by
// M(q) / q.q. In rationals the result is exact.
#pragma once

#include "common/geometry/pose.hpp"

#include <array>

namespace cd::tests {

/// Returns the linear part, row by row.
template <class N>
std::array<std::array<N, 3>, 3> rotation_in(const Pose& pose) {
    std::array<std::array<N, 3>, 3> r;
    if (pose.kind() == Pose::Kind::Matrix) {
        for (std::size_t i = 0; i < 9; ++i) {
            r[i / 3][i % 3] = N(
                pose.matrix()(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)));
        }
        return r;
    }
    const N w(pose.quaternion().w);
    const N x(pose.quaternion().x);
    const N y(pose.quaternion().y);
    const N z(pose.quaternion().z);
    const N s = N(2) / N(w * w + x * x + y * y + z * z);
    r[0] = {N(1 - s * (y * y + z * z)), N(s * (x * y - w * z)), N(s * (x * z + w * y))};
    r[1] = {N(s * (x * y + w * z)), N(1 - s * (x * x + z * z)), N(s * (y * z - w * x))};
    r[2] = {N(s * (x * z - w * y)), N(s * (y * z + w * x)), N(1 - s * (x * x + y * y))};
    return r;
}

/// Returns a corner of a posed body in world space.
template <class N>
std::array<N, 3> world_point(const Pose& pose, const Vec3& corner) {
    const auto r = rotation_in<N>(pose);
    std::array<N, 3> to;
    for (std::size_t i = 0; i < 3; ++i) {
        to[i] = r[i][0] * N(corner.x()) + r[i][1] * N(corner.y()) + r[i][2] * N(corner.z()) +
                N(pose.translation()[static_cast<Eigen::Index>(i)]);
    }
    return to;
}

} // namespace cd::tests
