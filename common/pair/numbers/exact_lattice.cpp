#include "common/pair/numbers/exact_lattice.hpp"

#include <algorithm>
#include <cstddef>

namespace cd {

namespace {

/// Expresses eighteen coordinates in the largest common unit that is a power of two.
ExactLattice lattice_of(const std::array<Dyadic, 18>& coordinates) {
    ExactLattice lattice;
    bool any = false;
    for (const Dyadic& value : coordinates) {
        if (value.mantissa != 0) {
            lattice.exponent = any ? std::min(lattice.exponent, value.exponent) : value.exponent;
            any = true;
        }
    }
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const Dyadic& value = coordinates[i];
        if (value.mantissa != 0) {
            lattice.corners[i / 3][i % 3] = value.mantissa << (value.exponent - lattice.exponent);
        }
    }
    return lattice;
}

} // namespace

std::array<Dyadic, 3> world_corner(const ExactPose& pose, const Vec3& corner) {
    const std::array<Dyadic, 3> x{
        to_dyadic(corner.x()), to_dyadic(corner.y()), to_dyadic(corner.z())};
    std::array<Dyadic, 3> result;
    for (std::size_t row = 0; row < 3; ++row) {
        const auto& r = pose.linear[row];
        result[row] = r[0] * x[0] + r[1] * x[1] + r[2] * x[2] + pose.translation[row];
    }
    return result;
}

ExactLattice exact_lattice(const ExactPose& pose_a,
                           const Corners& a,
                           const ExactPose& pose_b,
                           const Corners& b,
                           const Vec3& origin) {
    std::array<Dyadic, 18> coordinates;
    std::size_t place = 0;
    const auto map = [&](const Corners& corners, const ExactPose& pose, const Dyadic& other_norm) {
        std::array<Dyadic, 3> from;
        for (std::size_t k = 0; k < 3; ++k) {
            from[k] = to_dyadic(origin[static_cast<Eigen::Index>(k)]) * pose.norm;
        }
        for (const Vec3& corner : corners) {
            const std::array<Dyadic, 3> exact = world_corner(pose, corner);
            for (std::size_t k = 0; k < 3; ++k) {
                coordinates[place++] = (exact[k] - from[k]) * other_norm;
            }
        }
    };
    map(a, pose_a, pose_b.norm);
    map(b, pose_b, pose_a.norm);
    return lattice_of(coordinates);
}

} // namespace cd
