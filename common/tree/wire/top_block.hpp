// Encodes the upper tree as a block, which is sent, cached and named by its hash.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/tree/cut.hpp"

#include <span>

namespace cd {

/// Encodes an upper tree as canonical, uncompressed bytes:
///
///     u8 version = 1    u32 nodes    u32 triangles    the nodes (node_columns.hpp)
[[nodiscard]] Bytes encode_top(const TreeTop& top);

/// Decodes `encode_top`. The bytes are untrusted; nothing is allocated that they do not justify.
/// Errors: BadFrame.
[[nodiscard]] Result<TreeTop> decode_top(std::span<const std::byte> bytes);

} // namespace cd
