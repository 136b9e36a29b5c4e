// Selects the nodes of a binary tree that become nodes of the wide tree.
#pragma once

#include "common/tree/obb_tree.hpp"
#include "common/tree/wide/wide_leaves.hpp"

#include <cstdint>
#include <vector>

namespace cd {

/// A planned wide node. The children of a node are contiguous and come after it.
struct WidePlanNode {
    std::uint32_t begin = 0; ///< The node's triangles are [begin, end) of WideLeaves::order.
    std::uint32_t end = 0;
    std::uint32_t binary = 0; ///< Binary node whose frame this node may take; unused for a leaf.
    std::uint32_t first = 0;  ///< First child, by index in the plan; a leaf's number in WideLeaves.
    std::uint32_t count = 0;  ///< Number of children; 0 for a leaf.

    [[nodiscard]] bool is_leaf() const { return count == 0; }
};

/// Finds the plan whose nodes' boxes have the least sum of surface areas, since a search visits a
/// node about in proportion to its surface area. Uses dynamic programming over the number of
/// children that each part of the tree may become (Ylitie, Karras, Laine, Efficient Incoherent Ray
/// Traversal on GPUs Through Compressed Wide BVHs, 2017, section 3.1). The root comes first.
[[nodiscard]] std::vector<WidePlanNode> plan_wide_tree(const TreeView& tree,
                                                       const WideLeaves& leaves);

} // namespace cd
