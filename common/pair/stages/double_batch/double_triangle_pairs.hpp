// The double stage for many pairs at once, for scenes where ties are common.
#pragma once

#include "common/pair/poses/rounded_poses.hpp"
#include "common/pair/stages/double_batch/double_pairs_kernel.hpp"
#include "common/pair/triangle_pair.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace cd {

/// Decides up to eight pairs at once in doubles. Proves all that DoubleTrianglePair proves of
/// triangles with area, and slightly more for triangles that share a corner.
///
/// A pair's answer is the same on every SIMD target and independent of the other pairs.
class DoubleTrianglePairs {
  public:
    static constexpr std::size_t pairs_max = CornersOfMany::pairs;

    /// The poses must be plain (see `plain_poses`). Multiplies all error bounds by `bound_scale`;
    /// tests use less than 1 to show that the bounds are needed.
    explicit DoubleTrianglePairs(const PosePair& poses, double bound_scale = 1);

    /// Returns false if a SIMD vector holds one double only: then pairs are decided faster one by
    /// one.
    [[nodiscard]] bool pays() const { return pays_; }

    /// Adds a pair; at most `pairs_max` before the next `decide`.
    void add(const Corners& a, const Corners& b);
    /// Decides and removes the pairs added since the last call.
    void decide();
    /// Returns the class of pair number `number`, from 0, among those of the last `decide`; nothing
    /// if doubles leave the class open.
    [[nodiscard]] std::optional<PairClass> decided(std::size_t number) const {
        const std::uint8_t found = classes_[number];
        return found == undecided_pair ? std::nullopt
                                       : std::optional(static_cast<PairClass>(found));
    }

  private:
    RoundedPoses poses_;
    double bound_scale_;
    bool pays_;
    std::size_t count_ = 0;
    CornersOfMany corners_{};
    std::array<std::uint8_t, pairs_max> classes_{};
};

} // namespace cd
