// Exact reference for triangle pairs, in integers, by another method than the engine's.
#pragma once

#include "common/pair/triangle_pair.hpp"
#include "tests/support/exact_world.hpp"

namespace cd::tests {

/// Classifies the pair exactly on every input: lists the corners of the intersection and locates
/// them. Shares no code with the engine. Takes some microseconds; clipping_oracle.hpp is slower.
[[nodiscard]] PairClass oracle_class(const Corners& a, const Corners& b, const PosePair& poses);

/// Classifies two triangles given in world space.
[[nodiscard]] PairClass oracle_class(const ExactTriangle& a, const ExactTriangle& b);

/// A world point p / weight; the weight is positive.
struct WeightedPoint {
    ExactPoint p;
    Integer weight = 1;
};

/// Returns points whose convex hull is the intersection of the triangles, unordered, possibly
/// repeated; none if the triangles are apart.
[[nodiscard]] std::vector<WeightedPoint> shared_corners(const ExactTriangle& a,
                                                        const ExactTriangle& b);

} // namespace cd::tests
