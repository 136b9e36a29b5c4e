// Vector, matrix and triangle types.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace cd {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// A triangle as three vertex indices of its mesh.
using Triangle = std::array<std::uint32_t, 3>;

/// The corners of a triangle, in its body's coordinates.
using Corners = std::array<Vec3, 3>;

/// The corners of a pair's triangles, each in its body's coordinates.
struct PairCorners {
    Corners a;
    Corners b;
};

} // namespace cd
