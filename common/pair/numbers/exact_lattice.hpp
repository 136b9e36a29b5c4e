// The corners of two posed triangles as integers in one unit.
#pragma once

#include "common/geometry/types.hpp"
#include "common/pair/numbers/dyadic.hpp"

#include <array>

namespace cd {

using ExactVec = std::array<ExactInt, 3>;

/// The corners of A, then of B, as multiples of 2^exponent.
struct ExactLattice {
    std::array<ExactVec, 6> corners;
    int exponent = 0;
};

/// Returns the corner in the world, times the pose's norm.
[[nodiscard]] std::array<Dyadic, 3> world_corner(const ExactPose& pose, const Vec3& corner);

/// Returns the corners in the world minus `origin`, any finite point, times the product of both
/// norms.
[[nodiscard]] ExactLattice exact_lattice(const ExactPose& pose_a,
                                         const Corners& a,
                                         const ExactPose& pose_b,
                                         const Corners& b,
                                         const Vec3& origin);

} // namespace cd
