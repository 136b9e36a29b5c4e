// The nodes of a wide tree: boxes of up to sixteen children, as bytes in one frame.
#pragma once

#include "common/geometry/triangle_blocks.hpp"
#include "common/tree/planes/support_view.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace cd {

/// The most children of a node. A leaf's children are the triangles of a block.
inline constexpr std::uint32_t wide_children_max = block_size;

/// A node: a frame, and boxes of up to sixteen children in it. The k-th coordinate of a point x is
/// row_k . (x - origin), the rows taken as exact numbers; every point of a child's triangles has
/// its coordinates in [low[k] * steps[k], high[k] * steps[k]], in exact terms.
struct alignas(64) WideNode {
    using Bytes = std::array<std::uint8_t, wide_children_max>;

    std::array<Bytes, 3> low{}; ///< Indexed by axis, then by child; 0 for unused children.
    std::array<Bytes, 3> high{};
    /// columns[c][k] is entry c of row k; the rows are orthonormal within `axes_error_max`. The
    /// fourth entry is 0.
    std::array<std::array<float, 4>, 3> columns{};
    std::array<double, 3> origin{}; ///< Rounded to floats in a leaf whose vertices are floats.
    std::array<float, 4> steps{};   ///< Positive. The fourth is 1.
    std::uint32_t first = 0; ///< Index of the first child; for a leaf, the number of its block.
    std::uint8_t count = 0;  ///< Number of children; for a leaf, of triangles.
    bool is_leaf = false;
    std::array<std::uint8_t, 2> unused{}; ///< Padding; defines every byte of a node in a file.
};
static_assert(sizeof(WideNode) == 192);

/// A view of a wide tree's arrays. Node 0 is the root; the children of a node are contiguous.
struct WideView {
    std::span<const WideNode> nodes; ///< Empty where a body is unfit for a wide tree.
    TriangleBlocks triangles;
    double extent = 0;        ///< Upper bound on the absolute coordinates of origins.
    SupportView support = {}; ///< Empty unless points were made.
};

} // namespace cd
