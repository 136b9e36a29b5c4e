// How much disk space the master's state takes.
#pragma once

#include "proto/messages/client_messages.hpp"

#include <filesystem>

namespace cd {

/// Adds up the files of a state directory. Blocks for the disk. A file that cannot be read counts
/// as empty, since it may have been deleted meanwhile.
[[nodiscard]] StateSizes measure_state(const std::filesystem::path& state);

} // namespace cd
