// Measures the disk space that the master's state takes.
#pragma once

#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <filesystem>

namespace cd {

/// Adds up the files of a state directory. Blocks for the disk. An unreadable file counts as empty,
/// since it may just have been deleted.
[[nodiscard]] StateSizes measure_state(const std::filesystem::path& state);

/// Returns the size of the file system that holds the directory, in bytes; 0 if it is unknown.
[[nodiscard]] std::uint64_t disk_bytes(const std::filesystem::path& state);

} // namespace cd
