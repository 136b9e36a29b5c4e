// The shared points of many crossing pairs at once, where double-double can prove their rounding.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/points/crossing/crossing_kernel.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace cd {

/// Computes the origins and points that `SharedPoints` promises, of up to eight pairs at once. A
/// pair has an answer only if it provably crosses, and the rounding of each component is proven.
///
/// Answers have the same bits on every SIMD target, and do not depend on the other pairs.
class CrossingPoints {
  public:
    static constexpr std::size_t pairs_max = CornersOfMany::pairs;

    /// Multiplies all error bounds by `bound_scale`. Answers are right only from 1 on; tests use
    /// less to show that the bounds are needed.
    explicit CrossingPoints(const PosePair& poses, double bound_scale = 1);

    /// Returns false if a SIMD vector holds one double only: then pairs are faster one by one.
    [[nodiscard]] bool pays() const { return pays_; }

    /// Computes the points of at most `pairs_max` pairs.
    void compute(std::span<const PairCorners> pairs);

    /// Tests whether pair number `place` of the last `compute` has an answer.
    [[nodiscard]] bool is_proven(std::size_t place) const { return found_.proven[place] != 0; }
    /// Returns the first corner of A in the world, rounded, of a pair with an answer.
    [[nodiscard]] Vec3 origin(std::size_t place) const { return at(found_.origin, place); }
    /// Returns both ends of the shared segment of a pair with an answer, in order.
    [[nodiscard]] std::array<Vec3, 2> ends(std::size_t place) const {
        return {at(found_.ends[0], place), at(found_.ends[1], place)};
    }

  private:
    [[nodiscard]] static Vec3 at(const CrossingsOfMany::Vectors& vectors, std::size_t place) {
        return {vectors[0][place], vectors[1][place], vectors[2][place]};
    }

    CrossingPose a_;
    CrossingPose b_;
    double bound_scale_;
    bool pays_;
    CornersOfMany corners_{};
    CrossingsOfMany found_{};
};

} // namespace cd
