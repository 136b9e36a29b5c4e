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
///     u8 version = 2    u8 flags (bit 0: double vertices; bits 1 to 3 and 4 to 6: byte planes of
///         the vertices' numbers and of ids, 0 to 4)
///     varint nodes    varint vertices
///     nodes: u8 each, the children of the root, then what is below each of them, in turn: children
///         or triangles less 1 (4 bits), 16 for a leaf, 32 times the kind of its frame
///     frames that are not the body's: three columns of i16 (FrameCode)
///     corners of each triangle, leaf by leaf: u8, how far behind the next one of the leaf's
///         vertices that is not yet met; 0 is a new one
///     of each vertex that is new in its leaf: how far it is behind the next one of the block's
///     that
///         is not yet met; 0 is a new one
///     columns of the vertices: x, y, z (f32 or f64)
///     ids: in each leaf ascending, less the one before and 1; the first of a leaf as zigzag step
///         from the first of the leaf before
///
/// All columns but nodes and corners are stored as byte planes. A tree without nodes has no block.
[[nodiscard]] Bytes encode_wide_block(const WideView& wide);

/// Decodes `encode_wide_block`. The bytes may be hostile: every number is checked, and nothing is
/// allocated that they do not justify (at most 150 times their size: a leaf has room for sixteen
/// triangles and their boxes). The function does not check that ids are distinct: the block's hash
/// vouches for its origin. Errors: BadFrame.
[[nodiscard]] Result<WideTree> decode_wide_block(std::span<const std::byte> bytes);

} // namespace cd
