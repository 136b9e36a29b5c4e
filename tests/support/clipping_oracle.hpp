// The oracle's slow twin: clipping of polygons in canonical rationals.
#pragma once

#include "common/geometry/triangle_pair.hpp"

namespace cd::tests {

/// Clips one triangle by everything that bounds the other, exactly, and looks at what is left.
/// Shares no code with the engine nor with `oracle_class`. Slow: some hundred microseconds.
[[nodiscard]] PairClass
clipping_oracle_class(const Corners& a, const Corners& b, const PosePair& poses);

} // namespace cd::tests
