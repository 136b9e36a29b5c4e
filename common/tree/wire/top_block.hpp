// The top of a cut tree as bytes: streamed, cached and named by its hash like a subtree's block.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/tree/cut.hpp"

#include <span>

namespace cd {

/// The canonical, uncompressed bytes of a top:
///
///     u8 version = 1    u32 nodes    u32 triangles    the nodes (node_columns.hpp)
[[nodiscard]] Bytes encode_top(const TreeTop& top);

/// The inverse. The bytes may be hostile; nothing is allocated that they do not justify. Errors:
/// BadFrame.
[[nodiscard]] Result<TreeTop> decode_top(std::span<const std::byte> bytes);

} // namespace cd
