// The leaves of a wide tree: the triangles of a binary tree in groups that fill a node.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <vector>

namespace cd {

/// The leaves [leaves_begin, leaves_end) that are made of one binary node's triangles.
struct WideGroup {
    std::uint32_t node = 0;
    std::uint32_t leaves_begin = 0;
    std::uint32_t leaves_end = 0;
};

struct WideLeaf {
    std::uint32_t begin = 0; ///< The leaf's triangles are [begin, end) of WideLeaves::order.
    std::uint32_t end = 0;
    float surface = 0; ///< About half the surface area of the leaf's box.
};

struct WideLeaves {
    std::vector<std::uint32_t> order; ///< Triangles by index in the binary tree's order.
    std::vector<WideLeaf> leaves;
    std::vector<WideGroup> groups; ///< Ordered from left to right in the binary tree.
};

/// Makes the leaves of a wide tree. A group is a binary node with at most sixteen times sixteen
/// triangles whose parent has more. A group is divided into as few leaves as can hold its
/// triangles; binary nodes with at most sixteen would fill only two thirds of the SIMD lanes. A
/// group is halved where the sum of both boxes' surfaces, each times its number of leaves, is
/// least, as long as both halves fill their leaves; the boxes are those of triangles in the node's
/// frame. A leaf has its triangles in the order of their ids. The result is equal for any number of
/// threads; without a pool the caller's thread does all the work.
[[nodiscard]] WideLeaves make_wide_leaves(const TreeView& tree, ThreadPool* pool);

} // namespace cd
