// Compresses blocks and results. No other code uses zstd.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"

#include <cstddef>
#include <span>

namespace cd {

inline constexpr int compression_level_fast =
    1; ///< Level for results, which are written once and read once.
inline constexpr int compression_level_geometry =
    9; ///< Level for blocks, which are written once and sent often.

[[nodiscard]] Bytes compress(std::span<const std::byte> bytes, int level);

/// Errors: BadFrame if the bytes are not one zstd frame, TooLarge if it holds more than `size_max`
/// bytes. Memory use follows the actual output size, not the size that the frame claims.
[[nodiscard]] Result<Bytes> decompress(std::span<const std::byte> bytes, std::size_t size_max);

} // namespace cd
