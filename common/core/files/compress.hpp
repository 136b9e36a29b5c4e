// Compresses blocks and results with zstd, which no other code calls.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"

#include <cstddef>
#include <span>

namespace cd {

/// The levels of zstd: for what is written once and read once, for results, and for blocks of
/// geometry, which are written once and sent often. Results become a few percent smaller than at
/// the fastest level, which is affordable because their columns are a quarter as long as records.
inline constexpr int compression_level_fast = 1;
inline constexpr int compression_level_results = 3;
inline constexpr int compression_level_geometry = 9;

[[nodiscard]] Bytes compress(std::span<const std::byte> bytes, int level);

/// Decompresses one zstd frame. Errors: BadFrame for other or damaged bytes, TooLarge if the frame
/// claims more than `size_max` bytes. Memory use follows the actual output, not the claimed size.
[[nodiscard]] Result<Bytes> decompress(std::span<const std::byte> bytes, std::size_t size_max);

} // namespace cd
