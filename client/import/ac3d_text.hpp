// Reads an AC3D file by itself, to hold the importer against it.
#pragma once

#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace cd {

[[nodiscard]] bool is_ac3d(const std::filesystem::path& path, const std::string& lower_extension);

/// The number of triangles that a file's surfaces make, which the importer must take all.
///
/// The importer takes vertex 0 for an index that names none, half of a number like 1d5, and, where
/// a line is not what it expects, the rest of the file for something else; it goes as deep as the
/// objects are nested and subdivides surfaces as often as the file wants.
///
/// Errors: BadInput naming the file and the line, for each of these.
[[nodiscard]] Result<std::uint64_t> count_ac3d_triangles(const std::filesystem::path& path);

} // namespace cd
