// The two real bodies of the demo, from Debian packages.
#pragma once

#include "common/core/result.hpp"

#include <array>
#include <filesystem>
#include <optional>

namespace cd {

/// Returns this user's cache folder: cdcluster below $XDG_CACHE_HOME or ~/.cache. Returns nothing
/// if the environment names neither.
[[nodiscard]] std::optional<std::filesystem::path> own_cache_dir();

/// Returns `own_cache_dir`, or else a temporary folder that other users may share.
[[nodiscard]] std::filesystem::path cache_dir();

/// Finds the motorcycle with its rider (331,653 triangles) and the tram (36,762). Unpacks the
/// motorcycle into `cache` once. `root` is put before the packages' paths. Errors: NotFound naming
/// the packages to install; Io; BadInput for a damaged package file.
[[nodiscard]] Result<std::array<std::filesystem::path, 2>>
find_vehicles(const std::filesystem::path& cache, const std::filesystem::path& root = "/");

} // namespace cd
