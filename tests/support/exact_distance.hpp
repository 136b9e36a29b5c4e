// The distance of two posed meshes that do not touch, by the closest features, in rational numbers.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"

namespace cd::tests {

/// True when the exact distance of the two surfaces in the world is at most `bound`, which is
/// finite. The surfaces must not touch. Squares are compared, in rational numbers, for the pairs of
/// triangles that doubles show to be nearest. Shares no code with the engine.
[[nodiscard]] bool
distance_is_at_most(const Mesh& a, const Mesh& b, const PosePair& poses, double bound);

} // namespace cd::tests
