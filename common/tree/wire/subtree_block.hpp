// Encodes a distribution root's subtree as a block, which is sent, cached and named by its hash.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/subtree.hpp"

#include <span>

namespace cd {

/// Encodes a subtree that `extract_subtree` made as canonical, uncompressed bytes: equal trees give
/// equal bytes on any host. A wide subtree is encoded by `encode_wide_block`, a binary one as:
///
///     u8 version = 1    u8 flags (1: double vertices, 2: 32-bit corners)
///     u32 nodes    u32 vertices    u32 triangles
///     the nodes (node_columns.hpp)
///     columns of the vertices: x, y, z (f32 or f64)
///     three corners of each triangle (u16 or u32): distance behind the lowest vertex not yet used
///     triangle ids (u32): zigzag step from the previous id
///
/// Each column, the corners and the ids are stored as byte planes.
[[nodiscard]] Bytes encode_subtree(const Subtree& subtree);

/// Decodes `encode_subtree`. The bytes are untrusted: every index, range and number is checked,
/// and nothing is allocated that the bytes do not justify (at most 3 times their size, or the bound
/// of `decode_wide_block`). The function does not check that ids are distinct and that boxes of a
/// binary subtree contain their triangles: the block's hash vouches for its origin. Errors:
/// BadFrame.
[[nodiscard]] Result<Subtree> decode_subtree(std::span<const std::byte> bytes);

} // namespace cd
