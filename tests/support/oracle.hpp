// The truth about a pair of triangles, in whole numbers and by another way than the engine's.
#pragma once

#include "common/pair/triangle_pair.hpp"
#include "tests/support/exact_world.hpp"

namespace cd::tests {

/// Exact on every input, and shares no code with the engine: it lists the corners of the set that
/// the triangles share and looks where they lie. Some microseconds (clipping_oracle.hpp is its slow
/// twin).
[[nodiscard]] PairClass oracle_class(const Corners& a, const Corners& b, const PosePair& poses);

/// The same for two triangles in the world.
[[nodiscard]] PairClass oracle_class(const ExactTriangle& a, const ExactTriangle& b);

/// A point p / weight of the world; the weight is positive.
struct WeightedPoint {
    ExactPoint p;
    Integer weight = 1;
};

/// Points whose convex hull is the set that the two triangles share, in no order and some of them
/// perhaps several times; none where the triangles are apart.
[[nodiscard]] std::vector<WeightedPoint> shared_corners(const ExactTriangle& a,
                                                        const ExactTriangle& b);

} // namespace cd::tests
