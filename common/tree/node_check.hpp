// Checks boxes, nodes and triangle orders decoded from untrusted bytes: tree files and blocks.
#pragma once

#include "common/tree/obb_tree.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace cd {

/// Returns true when the box test is conservative for this box: axes orthonormal within
/// `axes_error_max`, a finite centre, half sizes that are normal floats or infinite. Does not check
/// that the box contains its triangles.
[[nodiscard]] bool is_valid_box(const ObbNode& node);

/// Returns true when the children of each inner node are where preorder puts them.
[[nodiscard]] bool is_preorder(std::span<const ObbNode> nodes);

/// Returns true when the triangle range of each node is not empty and joins its children's ranges,
/// and the first node's range begins at 0. Requires at least one node, and nodes in preorder.
[[nodiscard]] bool has_consecutive_ranges(std::span<const ObbNode> nodes);

/// Returns true when the nodes are a preorder over triangles 0 to `triangles` - 1, so that a
/// descent stays within both arrays and ends. Does not check the boxes.
[[nodiscard]] bool is_tree_over(std::span<const ObbNode> nodes, std::size_t triangles);

/// Returns true when `ids` contains each of `triangles` triangles exactly once.
[[nodiscard]] bool is_permutation_of_triangles(std::span<const std::uint32_t> ids,
                                               std::size_t triangles);

} // namespace cd
