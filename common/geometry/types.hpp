// The vectors and matrices of this project, and the small values made of them.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace cd {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// The three vertices of a mesh's triangle, as indices into its vertices.
using Triangle = std::array<std::uint32_t, 3>;

/// The three corners of a triangle, in its body's coordinates.
using Corners = std::array<Vec3, 3>;

} // namespace cd
