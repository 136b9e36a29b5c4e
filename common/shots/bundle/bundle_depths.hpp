// Depths at which parallel lines pass through triangles, many at a time.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/shots/bundle/bundle_depth_kernel.hpp"
#include "common/shots/bundle/parallel_lines.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>

namespace cd {

/// Computes depths of hits in double-double, rounded by Ziv's test: those of SegmentHit, or none.
/// Both ends of each line are strictly on different sides of its triangle.
class BundleDepths {
  public:
    /// Returns whether both poses are exactly rotations and translations.
    [[nodiscard]] static bool suits(const PosePair& poses);

    /// Multiplies all error bounds by `bound_scale`. Answers are right only from 1 on; tests use
    /// less to show that the bounds are needed.
    explicit BundleDepths(double bound_scale = 1);

    /// Selects poses that suit, and the bundle.
    void restart(const PosePair& poses, const ParallelLines& lines);

    [[nodiscard]] bool is_full() const { return count_ == DepthsOfMany::most; }
    /// Adds a triangle of A and the line at a place across; not when it is full.
    void add(const Corners& a, const std::array<double, 2>& across);
    /// Returns the depths of what was added since the last call, in that order, NaN where the
    /// bounds prove none. Valid until the next call of `add`.
    [[nodiscard]] std::span<const double> take();

  private:
    /// An axis of A that is along the lines, if the poses permute axes, and the terms whose sum
    /// with `sign` times a coordinate on it is the way from a line's start to there, exactly.
    struct AlignedAxis {
        std::size_t axis = 0;
        double sign = 0;
        std::array<double, 3> terms{};
    };
    [[nodiscard]] static std::optional<AlignedAxis> aligned_axis(const PosePair& poses,
                                                                 const ParallelLines& lines);
    [[nodiscard]] std::optional<double> aligned_depth(std::size_t place) const;

    double bound_scale_;
    BundleInA bundle_;
    std::optional<AlignedAxis> aligned_;
    std::unique_ptr<DepthsOfMany> many_;
    std::size_t count_ = 0;
};

} // namespace cd
