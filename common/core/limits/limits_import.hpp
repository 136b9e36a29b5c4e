// The bounds of the child process in which assimp reads a mesh file.
#pragma once

#include <chrono>
#include <cstdint>

namespace cd::limits {

/// The reader may use so much memory for any file, and more for a large one.
inline constexpr std::uint64_t reader_memory_bytes_min = 1ull << 30;
/// XML that is unpacked from a zip needs most.
inline constexpr std::uint64_t reader_memory_per_file_byte = 512;
/// The reader may use so much processor time for any file, and a second more for each
/// `reader_file_bytes_per_second`.
inline constexpr std::chrono::seconds reader_seconds_min{20};
inline constexpr std::uint64_t reader_file_bytes_per_second = 1u << 20;
/// Seconds by the clock for each second of processor time: hosts are shared.
inline constexpr int reader_real_seconds_each = 10;

} // namespace cd::limits
