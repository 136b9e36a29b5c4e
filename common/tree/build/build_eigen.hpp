// Computes the principal directions of symmetric 3 x 3 matrices, many at a time.
#pragma once

#include "common/geometry/types.hpp"

#include <array>
#include <span>

namespace cd {

/// The upper triangle of a symmetric matrix: xx, xy, xz, yy, yz, zz.
using SymmetricMatrix = std::array<double, 6>;

/// Three unit vectors.
using Directions = std::array<Vec3, 3>;

/// Computes unit eigenvectors, one set for each matrix. They are orthogonal within rounding; the
/// eigenvector of the smallest eigenvalue comes first. For a multiple of the unit matrix, and where
/// an entry is not finite, the result is the body's own axes.
///
/// The computation uses only plain operations and square roots, a fixed number of them, so that
/// every host, SIMD target and number of matrices gives the same bits.
void principal_directions(std::span<const SymmetricMatrix> matrices,
                          std::span<Directions> directions);

} // namespace cd
