// Compression of blocks and results. The only user of zstd.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"

#include <cstddef>
#include <span>

namespace cd {

inline constexpr int compression_level_fast = 1;     ///< Results, made once and read once.
inline constexpr int compression_level_geometry = 9; ///< Blocks, made once and sent often.

[[nodiscard]] Bytes compress(std::span<const std::byte> bytes, int level);

/// Errors: BadFrame if the bytes are not one zstd frame, TooLarge if it holds more than `size_max`
/// bytes. Takes no more memory than what really comes out, whatever the frame claims.
[[nodiscard]] Result<Bytes> decompress(std::span<const std::byte> bytes, std::size_t size_max);

} // namespace cd
