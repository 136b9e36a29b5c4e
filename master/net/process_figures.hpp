// What the operating system says of this process.
#pragma once

#include <cstdint>

namespace cd {

/// A figure that cannot be read is 0.
struct ProcessFigures {
    double started = 0; ///< Time of the start, in seconds since 1970.
    std::uint64_t resident_bytes = 0;
    std::uint64_t virtual_bytes = 0;
    std::uint64_t threads = 0;
    std::uint64_t open_files = 0;
    std::uint64_t open_files_max = 0;
};

/// Reads the figures from /proc. Never blocks for a disk.
[[nodiscard]] ProcessFigures process_figures();

} // namespace cd
