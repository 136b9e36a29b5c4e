// A wide tree as bytes: what exact searches of a subtree travel as.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <cstdint>
#include <span>

namespace cd {

inline constexpr std::uint8_t wide_block_version = 2;

/// The canonical, uncompressed bytes of a wide tree as `WideTree::of_part` makes them: the same for
/// the same tree, on any host. No box is among them: who decodes makes each of the triangles that
/// it bounds, in the frame that is named, and gets the same.
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
/// All columns but nodes and corners stand as byte planes. A tree without nodes has no block.
[[nodiscard]] Bytes encode_wide_block(const WideView& wide);

/// The inverse. The bytes may be hostile: every number is checked, and nothing is allocated that
/// they do not justify (at most 150 times their size: a leaf has room for sixteen triangles and
/// their boxes). That ids are distinct is not checked: the block's hash vouches for its origin.
/// Errors: BadFrame.
[[nodiscard]] Result<WideTree> decode_wide_block(std::span<const std::byte> bytes);

} // namespace cd
