// The leaves of a wide tree: the triangles of a binary tree in groups that fill a node.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// The leaves [leaves_begin, leaves_end) that are made of one binary node's triangles.
struct WideGroup {
    std::uint32_t node = 0;
    std::uint32_t leaves_begin = 0;
    std::uint32_t leaves_end = 0;
};

struct WideLeaf {
    std::uint32_t begin = 0; ///< Its triangles, as indices into WideLeaves::order.
    std::uint32_t end = 0;
    float surface = 0; ///< About half the surface of its box.
};

struct WideLeaves {
    std::vector<std::uint32_t> order; ///< Indices in the binary tree's order.
    std::vector<WideLeaf> leaves;
    std::vector<WideGroup> groups; ///< From left to right.
};

/// Makes the leaves of a wide tree. A group is a binary node with at most sixteen times sixteen
/// triangles whose parent has more. It becomes as few leaves as hold its triangles: binary nodes
/// with at most sixteen would fill two thirds of the lanes. It is halved where the boxes' surfaces,
/// each times its leaves, have the least sum, as long as both halves fill their leaves; the boxes
/// are those of triangles in the node's frame. A leaf has its triangles in the order of their ids.
/// The result is equal for any number of threads; without a pool the caller's thread does all the
/// work.
[[nodiscard]] WideLeaves make_wide_leaves(const TreeView& tree, ThreadPool* pool);

} // namespace cd
