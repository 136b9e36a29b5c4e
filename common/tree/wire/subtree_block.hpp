// One distribution root's subtree as bytes: what is streamed, cached, and named by its hash.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/subtree.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// The canonical, uncompressed bytes of a subtree as `extract_subtree` makes them: the same for the
/// same tree, on any host. Of a wide one what `encode_wide_block` says. Of a binary one:
///
///     u8 version = 1    u8 flags (1: double vertices, 2: 32-bit corners)
///     u32 nodes    u32 vertices    u32 triangles
///     the nodes (node_columns.hpp)
///     columns of the vertices: x, y, z (f32 or f64)
///     three corners of each triangle (u16 or u32): how far behind the next vertex not yet met
///     triangle ids (u32): the zigzag step from the id before
///
/// Each column, the corners and the ids stand as byte planes.
[[nodiscard]] Bytes encode_subtree(const Subtree& subtree);

/// The inverse. The bytes may be hostile: every index, range and number is checked, and nothing is
/// allocated that the bytes do not justify (at most 3 times their size, or what `decode_wide_block`
/// says). That ids are distinct, and boxes of a binary subtree contain their triangles, is not
/// checked: the block's hash vouches for its origin. Errors: BadFrame.
[[nodiscard]] Result<Subtree> decode_subtree(std::span<const std::byte> bytes);

} // namespace cd
