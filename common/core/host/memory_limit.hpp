// Finds the memory limit of this process.
#pragma once

#include <cstdint>
#include <filesystem>

namespace cd {

/// Returns the minimum, in bytes, of the host's memory and the limits of the process's control
/// groups (version 1 or 2), which containers and batch systems set. `root` differs only in tests.
[[nodiscard]] std::uint64_t memory_limit(const std::filesystem::path& root = "/");

} // namespace cd
