// Bodies in world space as integers: exact coordinates times one common positive number.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"

#include <gmpxx.h>

#include <array>
#include <span>
#include <vector>

namespace cd::tests {

using Integer = mpz_class;
using ExactPoint = std::array<Integer, 3>;
using ExactTriangle = std::array<ExactPoint, 3>;

/// The points of two bodies, both scaled by one number, which changes no answer about them. The
/// points in the world are these times 2^exponent / denominator.
struct ExactWorld {
    std::vector<ExactPoint> a;
    std::vector<ExactPoint> b;
    int exponent = 0;
    Integer denominator = 1;
};

/// Applies poses as the contract defines them: doubles are exact rationals; a quaternion q rotates
/// by M(q) / q.q.
[[nodiscard]] ExactWorld
exact_world(std::span<const Vec3> a, std::span<const Vec3> b, const PosePair& poses);

/// Returns the triangles of a mesh whose vertices are at these points.
[[nodiscard]] std::vector<ExactTriangle> triangles_of(const Mesh& mesh,
                                                      const std::vector<ExactPoint>& points);

[[nodiscard]] ExactPoint minus(const ExactPoint& l, const ExactPoint& r);
[[nodiscard]] Integer dot(const ExactPoint& l, const ExactPoint& r);
[[nodiscard]] ExactPoint cross(const ExactPoint& l, const ExactPoint& r);
/// Cross product of two edges; zero for a triangle without area.
[[nodiscard]] ExactPoint normal_of(const ExactTriangle& t);
[[nodiscard]] bool is_zero(const ExactPoint& p);

} // namespace cd::tests
