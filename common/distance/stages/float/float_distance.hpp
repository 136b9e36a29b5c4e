// The float stage of distances: many pairs at once, with error bounds. The stage proves an answer
// or gives none.
#pragma once

#include "common/distance/stages/float/near_pair_kernel.hpp"
#include "common/geometry/pose.hpp"
#include "common/geometry/triangle_blocks.hpp"
#include "common/pair/stages/float/float_pair_kernel.hpp"
#include "common/pair/triangle_pair.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// What floats prove about a pair and a distance.
enum class NearVerdict : std::uint8_t {
    Unknown = near_verdict::unknown,
    Far = near_verdict::far,   ///< Farther apart than the distance.
    Near = near_verdict::near, ///< At most so far apart.
};

/// Decides most pairs of ordinary scenes under one pair of poses. Works in A's coordinates, where
/// lengths are those of the world but for roundings of A's matrix; a matrix that is less rigid
/// leaves all pairs unknown.
class FloatDistance {
  public:
    /// Multiplies all error bounds by `error_scale`. Answers are right only from 1 on; tests use
    /// less to show that the error bounds are needed.
    explicit FloatDistance(const PosePair& poses, double error_scale = 1);

    /// Writes one verdict per candidate of two bodies, each a TriangleSpan or TriangleBlocks, for
    /// the distance d, finite and not negative. Never allocates.
    template <class Triangles>
    void decide(const Triangles& a,
                const Triangles& b,
                std::span<const Candidate> candidates,
                double d,
                std::span<NearVerdict> verdicts) const;

    /// Writes numbers between which the distance of each candidate is; 0 and infinity where floats
    /// prove nothing. Never allocates.
    template <class Triangles>
    void bound(const Triangles& a,
               const Triangles& b,
               std::span<const Candidate> candidates,
               std::span<float> lower,
               std::span<float> upper) const;

  private:
    FloatPairPose pose_;
    NearPairErrors errors_;
    bool is_usable_ = false; ///< If false, nothing can be proven.
};

} // namespace cd
