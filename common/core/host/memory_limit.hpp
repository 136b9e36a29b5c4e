// How much memory this process may use.
#pragma once

#include <cstdint>
#include <filesystem>

namespace cd {

/// The least of the host's memory and the limits of the control groups (version 2, or 1) that the
/// process is in, as a container or a batch system sets them. `root` is /, but for tests.
[[nodiscard]] std::uint64_t memory_limit(const std::filesystem::path& root = "/");

} // namespace cd
