// The truth about a pair of triangles, in rational arithmetic and by another way than the engine's.
#pragma once

#include "common/geometry/triangle_pair.hpp"

namespace cd::tests {

/// Clips one triangle by everything that bounds the other, exactly, and looks at what is left.
/// Shares no code with the engine. Slow: some hundred microseconds.
[[nodiscard]] PairClass oracle_class(const Corners& a, const Corners& b, const PosePair& poses);

} // namespace cd::tests
