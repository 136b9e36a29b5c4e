// Encodes a wide tree as a block: the form in which subtrees for exact searches are sent.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <cstdint>
#include <span>

namespace cd {

inline constexpr std::uint8_t wide_block_version = 2;

/// Encodes a wide tree that `WideTree::of_part` made as canonical, uncompressed bytes: equal trees
/// give equal bytes on any host. The bytes contain no boxes: the decoder recomputes each box from
/// the triangles that it bounds, in the encoded frame, and gets equal bits.
///
///     u8 version = 2
///     u8 flags (bit 0: double vertices; bits 1 to 3: byte planes of the vertices' numbers; bits 4
///         to 6: byte planes of ids; 0 to 4 planes each)
///     varint nodes    varint vertices
///     nodes, u8 each: the root, its children, then all nodes below each child in turn, likewise
///         (bits 0 to 3: children or triangles, less 1; bit 4: leaf; bits 5 to 7: kind of frame)
///     frames that are not the body's: three columns of i16 (FrameCode)
///     corners of each triangle, leaf by leaf (u8): distance behind the leaf's lowest vertex
///         not yet used; 0 is that vertex
///     vertices' numbers, for each vertex of each leaf: distance behind the block's lowest vertex
///         not yet used; 0 is that vertex
///     columns of the vertices: x, y, z (f32 or f64)
///     ids, ascending in each leaf: the id less the previous id, less 1; the first of a leaf as
///         zigzag step from the first of the previous leaf
///
/// All columns but nodes and corners are stored as byte planes. A tree without nodes has no block.
[[nodiscard]] Bytes encode_wide_block(const WideView& wide);

/// Decodes `encode_wide_block`. The bytes are untrusted: every number is checked, and nothing is
/// allocated that they do not justify (at most 150 times their size: a leaf has room for sixteen
/// triangles and their boxes). The function does not check that ids are distinct: the block's hash
/// vouches for its origin. Errors: BadFrame.
[[nodiscard]] Result<WideTree> decode_wide_block(std::span<const std::byte> bytes);

} // namespace cd
