// The first stage of the decision: floats with error bounds, many pairs at once.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/triangle_blocks.hpp"
#include "common/pair/stages/float/float_pair_kernel.hpp"
#include "common/pair/triangle_pair.hpp"

#include <span>

namespace cd {

/// What floats prove of a pair.
enum class FloatVerdict : std::uint8_t {
    Unknown = 0,
    Separate = 1,
    Proper = 2,
};

/// Decides most pairs of ordinary scenes under one pair of poses. It works in A's coordinates: what
/// parts or joins two triangles there does so in the world, A's pose being an invertible map.
///
/// The verdicts are the same bits on every SIMD target, and of a pair whatever stands beside it;
/// but what is known of a pair from blocks may depend on their `reach`.
class FloatTrianglePair {
  public:
    /// `bound_scale` is for tests, which show that smaller bounds prove what is not true.
    explicit FloatTrianglePair(const PosePair& poses, double bound_scale = 1);

    /// One verdict for each candidate. Never allocates.
    void classify(const TriangleSpan& a,
                  const TriangleSpan& b,
                  std::span<const Candidate> candidates,
                  std::span<FloatVerdict> verdicts) const;
    void classify(const TriangleBlocks& a,
                  const TriangleBlocks& b,
                  std::span<const Candidate> candidates,
                  std::span<FloatVerdict> verdicts) const;

  private:
    FloatPairPose pose_;
};

} // namespace cd
