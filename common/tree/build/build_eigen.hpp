// Principal directions of symmetric 3 x 3 matrices, many at a time.
#pragma once

#include "common/geometry/types.hpp"

#include <array>
#include <span>

namespace cd {

/// A symmetric matrix by its upper triangle: xx, xy, xz, yy, yz, zz.
using SymmetricMatrix = std::array<double, 6>;

/// Unit vectors.
using Directions = std::array<Vec3, 3>;

/// Unit eigenvectors, orthogonal within rounding, that of the smallest eigenvalue first; one set
/// for each matrix. For a multiple of the unit matrix, and where an entry is not finite, the body's
/// own directions.
///
/// Of plain operations and square roots alone, and in a fixed number of them: every host, SIMD
/// target and number of matrices gets the same bits.
void principal_directions(std::span<const SymmetricMatrix> matrices,
                          std::span<Directions> directions);

} // namespace cd
