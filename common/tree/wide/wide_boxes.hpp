// The boxes of a wide tree's nodes, made of the triangles' vertices: where the tree is built, and
// where it comes from elsewhere without them.
#pragma once

#include "common/tree/wide/wide_node.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Coordinates and the whole tree's size are between these, with room for products of floats.
inline constexpr double wide_coordinate_max = 0x1p50;
inline constexpr double wide_size_min = 0x1p-40;

/// Sets frame, origin, steps and boxes of all nodes that have `is_leaf`, `count` and `first`: a
/// node's children, or a leaf's triangles, are bounded in the frame at hand for it, in exact terms.
/// Frames are rows that are orthonormal within `axes_error_max`; coordinates are below
/// `wide_coordinate_max`. The blocks under each node stand side by side, and children stand behind
/// their parents. The same bits for the same nodes on every host and for any number of threads.
class WideBoxes {
  public:
    using Axes = std::array<float, 9>; ///< Three rows.

    WideBoxes(const TriangleBlocks& blocks, std::span<const WideNode> nodes);

    /// The node with its boxes in this frame. For any number of threads at once.
    [[nodiscard]] WideNode in_frame(std::size_t node, const Axes& axes) const;

  private:
    struct Run {
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
    };

    TriangleBlocks blocks_;
    std::span<const WideNode> nodes_;
    std::vector<Run> vertices_; ///< Under each node.
};

/// The sum of half the surfaces of its children's boxes.
[[nodiscard]] double cost_of(const WideNode& node);

/// No origin has a larger coordinate.
[[nodiscard]] double extent_of(std::span<const WideNode> nodes);

} // namespace cd
