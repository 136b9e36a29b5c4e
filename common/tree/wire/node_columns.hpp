// Encodes the nodes of a binary tree: part of the block of a subtree or of an upper tree.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace cd {

inline constexpr std::size_t node_bytes_min = 73; ///< Least bytes of one node.

/// Writes boxes so that they decode to exactly themselves, then the shape of the tree:
///
///     columns of the nodes: center x y z (f64), axes 0-5 (f32), axes 6-8 (u32: bits less those of
///         the cross product of the first two rows), half x y z (f32)
///     for each node in preorder, a varint: 0, or the number of a leaf's triangles
///
/// Each column is split into byte planes, lowest first, which compress better.
void put_nodes(ByteWriter& out, std::span<const ObbNode> nodes);

/// Decodes `put_nodes` into `nodes`. Returns false when the bytes, which are untrusted, end early,
/// are no tree over `triangles` triangles, or have a box that `is_valid_box` does not admit.
[[nodiscard]] bool get_nodes(ByteReader& in, std::span<ObbNode> nodes, std::uint32_t triangles);

} // namespace cd
