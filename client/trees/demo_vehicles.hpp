// The two real bodies of the demo, which come in Debian packages.
#pragma once

#include "common/core/result.hpp"

#include <array>
#include <filesystem>
#include <optional>

namespace cd {

/// Where this user's cached files are: $XDG_CACHE_HOME or ~/.cache, and cdcluster below it. Nothing
/// where the environment names neither.
[[nodiscard]] std::optional<std::filesystem::path> own_cache_dir();

/// The same, or a place among the temporary files that other users may share.
[[nodiscard]] std::filesystem::path cache_dir();

/// The motorcycle with its rider (331,653 triangles) and the tram (36,762). The first is unpacked
/// into `cache` once. `root` stands before the packages' paths.
/// Errors: NotFound naming the packages to install; Io.
[[nodiscard]] Result<std::array<std::filesystem::path, 2>>
find_vehicles(const std::filesystem::path& cache, const std::filesystem::path& root = "/");

} // namespace cd
