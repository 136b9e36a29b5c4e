// The nodes of a wide tree: up to sixteen children each, their boxes in one frame, as bytes.
#pragma once

#include "common/geometry/triangle_blocks.hpp"

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

    std::array<Bytes, 3> low{}; ///< Of each axis, then of each child. Unused children: 0.
    std::array<Bytes, 3> high{};
    /// columns[c][k] is entry c of row k; the rows are orthonormal within `axes_error_max`. The
    /// fourth entry is 0.
    std::array<std::array<float, 4>, 3> columns{};
    std::array<double, 3> origin{}; ///< Of a leaf whose vertices are floats: floats.
    std::array<float, 4> steps{};   ///< Positive. The fourth is 1.
    std::uint32_t first = 0;        ///< The first child's index; of a leaf, its block's number.
    std::uint8_t count = 0;
    bool is_leaf = false;
    std::array<std::uint8_t, 2> unused{}; ///< So that each byte of an array has a value.
};
static_assert(sizeof(WideNode) == 192);

/// Wherever the arrays live. Node 0 is the root; the children of a node stand side by side.
struct WideView {
    std::span<const WideNode> nodes; ///< Empty where a body cannot have such a tree.
    TriangleBlocks triangles;
    double extent = 0; ///< No origin has a larger coordinate.
};

} // namespace cd
