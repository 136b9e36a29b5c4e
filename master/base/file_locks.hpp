// Finds out whether a file system has the locks that a master's state needs.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>

namespace cd {

/// Takes and drops, in a new file of `directory`, the two kinds of locks that a master's state
/// needs: of a whole file, which keeps other masters away, and of a range of bytes, which SQLite
/// takes. Some network file systems lack them. Errors: Io, with a remedy.
[[nodiscard]] Status check_file_locks(const std::filesystem::path& directory);

} // namespace cd
