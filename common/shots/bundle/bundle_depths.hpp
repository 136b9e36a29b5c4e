// Depths at which parallel lines pass through triangles, many at a time.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/triangle_blocks.hpp"
#include "common/shots/bundle/bundle_depth_kernel.hpp"
#include "common/shots/bundle/parallel_lines.hpp"
#include "common/shots/bundle/passed_triangle.hpp"

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

    /// Sets the poses, for which `suits` must hold, and the bundle, which must outlive all calls of
    /// `find`.
    void restart(const PosePair& poses, const ParallelLines& lines);

    /// Appends the depth of each of `lines`, which are indices into `LineRows`, to `depths`. A
    /// depth is NaN if the error bounds do not prove its rounding. `triangles` of A tell which of
    /// the lines pass through each.
    void find(const TriangleBlocks& a,
              std::span<const PassedTriangle> triangles,
              std::span<const std::uint32_t> lines,
              std::vector<double>& depths);

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
    [[nodiscard]] std::optional<double> aligned_depth(const Corners& corners) const;
    /// Progress of `find`.
    struct Taken {
        std::size_t triangles = 0; ///< All lines of these.
        std::size_t lines = 0;
    };
    void take(std::span<const PassedTriangle> triangles,
              std::span<const std::uint32_t> lines,
              Taken& taken);
    void align(const TriangleBlocks& a, std::size_t triangle);

    double bound_scale_;
    BundleInA bundle_;
    LineRows rows_{};
    std::optional<AlignedAxis> aligned_;
    std::unique_ptr<DepthsOfMany> many_; ///< Those in work.
};

} // namespace cd
