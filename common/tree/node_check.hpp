// What is asked of boxes that come from elsewhere.
#pragma once

#include "common/tree/obb_tree.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace cd {

/// True when the box is one that the box test can take: axes orthonormal within `axes_error_max`, a
/// finite centre, half sizes that are normal floats or infinite. Any such box is tested
/// conservatively; that it contains its triangles cannot be told from it.
[[nodiscard]] bool is_valid_box(const ObbNode& node);

/// Whether the children of each inner node stand where preorder puts them.
[[nodiscard]] bool is_preorder(std::span<const ObbNode> nodes);

/// Whether the triangles of each node are those of its children, and all begin at 0. The nodes, one
/// at least, are in preorder.
[[nodiscard]] bool has_consecutive_ranges(std::span<const ObbNode> nodes);

/// All that a descent to so many triangles relies on, but for the boxes.
[[nodiscard]] bool is_tree_over(std::span<const ObbNode> nodes, std::size_t triangles);

/// True when each of so many triangles is there once.
[[nodiscard]] bool is_permutation_of_triangles(std::span<const std::uint32_t> ids,
                                               std::size_t triangles);

} // namespace cd
