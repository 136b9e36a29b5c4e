// The nodes of a binary tree as bytes: part of a subtree's block and of a top's.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace cd {

inline constexpr std::size_t node_bytes_min = 73; ///< Of one node.

/// Boxes so that they decode to exactly themselves, then the shape of the tree:
///
///     columns of the nodes: center x y z (f64), axes 0-5 (f32), axes 6-8 (u32: bits less those of
///         the cross product of the first two rows), half x y z (f32)
///     of each node in preorder a varint: 0, or the number of a leaf's triangles
///
/// Each column stands as byte planes, lowest first, which compress better.
void put_nodes(ByteWriter& out, std::span<const ObbNode> nodes);

/// The inverse, into so many nodes. False when the bytes, which may be hostile, end early, or are
/// no tree over so many triangles, or have a box that `is_valid_box` does not admit.
[[nodiscard]] bool get_nodes(ByteReader& in, std::span<ObbNode> nodes, std::uint32_t triangles);

} // namespace cd
