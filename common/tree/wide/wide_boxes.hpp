// Computes the boxes of a wide tree's nodes from the triangles' vertices, both in a build and when
// a tree without boxes is decoded.
#pragma once

#include "common/tree/wide/wide_node.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// A wide tree's coordinates are below this bound, so that products of floats do not overflow.
inline constexpr double wide_coordinate_max = 0x1p50;
/// A body with a wide tree exceeds this length on some axis, so that products of floats do not
/// underflow.
inline constexpr double wide_size_min = 0x1p-40;

/// Completes nodes in which only `is_leaf`, `count` and `first` are set. Bounds a node's children,
/// or a leaf's triangles, by boxes in a given frame, in exact terms. Rows of frames are orthonormal
/// within `axes_error_max`; coordinates are below `wide_coordinate_max`. The blocks under each node
/// are contiguous, and children come after their parents. Equal nodes give equal bits on every host
/// and for any number of threads.
class WideBoxes {
  public:
    using Axes = std::array<float, 9>; ///< Three rows.

    WideBoxes(const TriangleBlocks& blocks, std::span<const WideNode> nodes);

    /// Returns node number `node` with the frame `axes`, origin, steps and boxes. Any number of
    /// threads may call this function at once.
    [[nodiscard]] WideNode in_frame(std::size_t node, const Axes& axes) const;

  private:
    struct Run {
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
    };

    TriangleBlocks blocks_;
    std::span<const WideNode> nodes_;
    std::vector<Run> vertices_; ///< The run of vertices under each node.
};

/// Returns half the sum of the surface areas of the children's boxes of `node`.
[[nodiscard]] double cost_of(const WideNode& node);

/// Returns the largest absolute coordinate of any node's origin.
[[nodiscard]] double extent_of(std::span<const WideNode> nodes);

} // namespace cd
