// The bounds of the process that reads a mesh file with foreign code.
#pragma once

#include <chrono>
#include <cstdint>

namespace cd::limits {

inline constexpr std::uint64_t reader_memory_bytes_min = 1ull << 30;
inline constexpr std::uint64_t reader_memory_per_file_byte = 512; ///< XML unpacked from a zip.
inline constexpr std::chrono::seconds reader_seconds_min{20};     ///< Of a processor.
inline constexpr std::uint64_t reader_file_bytes_per_second = 1u << 20;
inline constexpr int reader_real_seconds_each = 10; ///< For one of a processor: hosts are shared.

} // namespace cd::limits
