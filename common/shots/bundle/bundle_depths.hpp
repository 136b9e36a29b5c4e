// Depths at which parallel lines pass through triangles, many at a time.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/triangle_blocks.hpp"
#include "common/shots/bundle/bundle_depth_kernel.hpp"
#include "common/shots/bundle/parallel_lines.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

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

    /// Selects poses that suit, and the bundle, which outlives all calls of `add`.
    void restart(const PosePair& poses, const ParallelLines& lines);

    /// Adds the triangle of A in a slot, and lines that pass through it, by their places in
    /// `LineRows`.
    void add(const TriangleBlocks& a, std::uint32_t slot, std::span<const std::uint32_t> lines);
    /// Returns the depths of all lines that were added since the last call, in that order, NaN
    /// where the bounds prove none. Valid until the next call of `add`.
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
    [[nodiscard]] std::optional<double> aligned_depth(std::size_t triangle) const;
    void add_triangle(const TriangleBlocks& a, std::uint32_t slot);
    void find_waiting();
    void align(std::size_t triangle);

    double bound_scale_;
    BundleInA bundle_;
    LineRows rows_{};
    std::optional<AlignedAxis> aligned_;
    std::unique_ptr<DepthsOfMany> many_; ///< What was added, but for what has its depth.
    std::size_t triangles_ = 0;          ///< Of `many_`.
    std::size_t lines_ = 0;              ///< Of `many_`.
    bool is_taken_ = false;
    std::vector<double> depths_;
};

} // namespace cd
