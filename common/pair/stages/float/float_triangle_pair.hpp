// The first stage of the decision: floats with error bounds, many pairs at once.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/triangle_blocks.hpp"
#include "common/pair/stages/float/float_pair_kernel.hpp"
#include "common/pair/triangle_pair.hpp"

#include <span>

namespace cd {

/// A pair's class as far as floats prove it.
enum class FloatVerdict : std::uint8_t {
    Unknown = 0,
    Separate = 1,
    Proper = 2,
};

/// Decides most pairs of ordinary scenes under one pair of poses. Works in A's coordinates: A's
/// pose is an invertible map, so a pair has the same class there as in the world.
///
/// The verdicts are the same on every SIMD target and independent of the other pairs. Which pairs
/// of blocks are proven may depend on the blocks' `reach`.
class FloatTrianglePair {
  public:
    /// Multiplies all error bounds by `bound_scale`. Verdicts are right only from 1 on; tests use
    /// less to show that the bounds are needed.
    explicit FloatTrianglePair(const PosePair& poses, double bound_scale = 1);

    /// Writes one verdict per candidate of two bodies, each a TriangleSpan or TriangleBlocks. Never
    /// allocates.
    template <class Triangles>
    void classify(const Triangles& a,
                  const Triangles& b,
                  std::span<const Candidate> candidates,
                  std::span<FloatVerdict> verdicts) const;

  private:
    FloatPairPose pose_;
};

} // namespace cd
