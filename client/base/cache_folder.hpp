// The folder for files that may be lost.
#pragma once

#include <filesystem>
#include <optional>

namespace cd {

/// Returns this user's cache folder: cdcluster below $XDG_CACHE_HOME or ~/.cache. Returns nothing
/// if the environment names neither.
[[nodiscard]] std::optional<std::filesystem::path> own_cache_dir();

/// Returns `own_cache_dir`, or else a temporary folder that other users may share.
[[nodiscard]] std::filesystem::path cache_dir();

} // namespace cd
