// The double stage of the decision for many pairs at once: where ties are the normal case.
#pragma once

#include "common/pair/stages/double_batch/double_pairs_kernel.hpp"
#include "common/pair/stages/float/rounded_poses.hpp"
#include "common/pair/triangle_pair.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace cd {

/// Holds up to eight pairs and says of each what doubles prove under the exact poses: what
/// DoubleTrianglePair proves of triangles with area, and a little more of those that share a
/// corner.
///
/// The answers are the same on every SIMD target, and of a pair whatever stands beside it.
class DoubleTrianglePairs {
  public:
    static constexpr std::size_t pairs_max = CornersOfMany::pairs;

    /// The poses are plain. All error bounds are multiplied by `bound_scale`, for tests that these
    /// have teeth.
    explicit DoubleTrianglePairs(const PosePair& poses, double bound_scale = 1);

    /// False where the processor takes one double at a time, so that pairs are better decided one
    /// by one.
    [[nodiscard]] bool pays() const { return pays_; }

    /// There is room for another.
    void add(const Corners& a, const Corners& b);
    /// Decides those that were added since the last call, and forgets them.
    void decide();
    /// Of the pair that was added as `place`, before the last call of `decide`.
    [[nodiscard]] std::optional<PairClass> decided(std::size_t place) const {
        const std::uint8_t found = classes_[place];
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
