// The map from A's coordinates into those of a bundle of parallel lines, with error bounds.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <array>
#include <cstddef>

namespace cd {

/// Maps points of A into the bundle's coordinates, whose axes are taken in the order of the lines'
/// axis and the two axes across, so that 0 is along the lines. Rotations keep the signs of
/// determinants, and this is why the bundle's pose has to be one; A's pose may be any.
class BundleFrame {
  public:
    /// Returns whether the bundle's pose is exactly a rotation and a translation.
    [[nodiscard]] static bool suits(const PosePair& poses);

    /// Selects poses that suit, and lines along an axis of B. `reach` bounds the coordinates of A's
    /// vertices and of its nodes' origins.
    BundleFrame(const PosePair& poses, std::size_t axis, double reach);

    /// Returns the rows of the linear part.
    [[nodiscard]] const std::array<std::array<double, 3>, 3>& rows() const { return rows_; }
    [[nodiscard]] const std::array<double, 3>& translation() const { return translation_; }
    /// Bounds the error of each coordinate row . x + translation, which is computed in doubles, of
    /// a vertex x; not finite if it is unknown.
    [[nodiscard]] double error() const { return error_; }
    /// Bounds the length of each row, at least 1.
    [[nodiscard]] double stretch() const { return stretch_; }

  private:
    std::array<std::array<double, 3>, 3> rows_{};
    std::array<double, 3> translation_{};
    double error_ = 0;
    double stretch_ = 1;
};

/// A node's box across the lines: coordinate `which` of a child is at most `margin` beyond
///     base + the sum over k of steps[k] * low[k] or high[k],
/// the lesser for the lower bound, in floats, relative to `middle`.
struct NodeAcross {
    struct Axis {
        float base = 0;
        std::array<float, 3> steps{};
        float margin = 0;
    };
    std::array<Axis, 2> axes{};
};

/// Returns the map of a node's bytes, relative to a point `middle` across the lines.
[[nodiscard]] NodeAcross
node_across(const WideNode& node, const BundleFrame& frame, const std::array<double, 2>& middle);

} // namespace cd
