// Computes the exact distance of two disjoint posed meshes by closest features, in rationals.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"

namespace cd::tests {

/// True if the exact distance of two disjoint surfaces is at most `bound`, which is finite.
/// Compares squares, in rationals, for the triangle pairs that doubles show to be nearest. Shares
/// no code with the engine.
[[nodiscard]] bool
distance_is_at_most(const Mesh& a, const Mesh& b, const PosePair& poses, double bound);

} // namespace cd::tests
