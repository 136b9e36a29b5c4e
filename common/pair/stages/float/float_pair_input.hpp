// What the SIMD kernels of pairs in floats read: poses and bodies as plain values.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/triangle_blocks.hpp"
#include "common/pair/stages/float/float_pair_kernel.hpp"
#include "common/pair/triangle_pair.hpp"

namespace cd {

/// Computes B's pose in A's coordinates and the constants that float_pair_kernel.cpp derives,
/// raised slightly to cover the roundings of their own computation. Multiplies all error bounds by
/// `bound_scale`; less than 1 proves nothing.
[[nodiscard]] FloatPairPose float_pair_pose(const PosePair& poses, double bound_scale);

/// Views the triangles of a body, which must outlive the result.
[[nodiscard]] FloatPairBody float_pair_body(const TriangleSpan& span);
[[nodiscard]] FloatPairBody float_pair_body(const TriangleBlocks& blocks);

} // namespace cd
