// How much of the disk the master's state takes.
#pragma once

#include "proto/client_messages.hpp"

#include <filesystem>

namespace cd {

/// Adds up the files of a state directory. Blocks for the disk. What cannot be read counts nothing:
/// files may go meanwhile.
[[nodiscard]] StateSizes measure_state(const std::filesystem::path& state);

} // namespace cd
