// The two bodies of the demo: generated vehicles, or real ones from Debian packages.
#pragma once

#include "common/core/result.hpp"

#include <array>
#include <filesystem>

namespace cd {

/// Writes a generated truck (about 100,000 triangles) and a car (30,000) into `folder` as
/// truck.obj and car.obj, and returns their paths. Errors: Io naming the file.
[[nodiscard]] Result<std::array<std::filesystem::path, 2>>
write_vehicles(const std::filesystem::path& folder);

/// Finds the motorcycle with its rider (331,653 triangles) and the tram (36,762) of the packages
/// openfoam-examples and sumo-tools. Unpacks the motorcycle into `cache` once. `root` is put before
/// the packages' paths. Errors: NotFound naming the packages to install; Io; BadInput for a damaged
/// package file.
[[nodiscard]] Result<std::array<std::filesystem::path, 2>>
find_debian_vehicles(const std::filesystem::path& cache, const std::filesystem::path& root = "/");

} // namespace cd
