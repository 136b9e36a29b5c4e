// Which nodes of a binary tree become nodes of the wide one.
#pragma once

#include "common/tree/obb_tree.hpp"
#include "common/tree/wide/wide_leaves.hpp"

#include <cstdint>
#include <vector>

namespace cd {

/// A wide node to be. The children of a node stand side by side, behind it.
struct WidePlanNode {
    std::uint32_t begin = 0; ///< Its triangles, as places in WideLeaves::order.
    std::uint32_t end = 0;
    std::uint32_t binary = 0; ///< The binary node whose frame it may have; not of a leaf.
    std::uint32_t first = 0;  ///< Its first child in the plan; of a leaf, its number.
    std::uint32_t count = 0;  ///< Of children; of a leaf 0.

    [[nodiscard]] bool is_leaf() const { return count == 0; }
};

/// The plan whose nodes' boxes have the least sum of surfaces, since a node is visited about as
/// often as its box is large: dynamic programming over the number of children that each part of the
/// tree may become (Ylitie, Karras, Laine, Efficient Incoherent Ray Traversal on GPUs Through
/// Compressed Wide BVHs, 2017, section 3.1). The root comes first.
[[nodiscard]] std::vector<WidePlanNode> plan_wide_tree(const TreeView& tree,
                                                       const WideLeaves& leaves);

} // namespace cd
