// Counts the triangles of an AC3D file independently, as a check on the importer.
#pragma once

#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace cd {

[[nodiscard]] bool is_ac3d(const std::filesystem::path& path, const std::string& lower_extension);

/// Counts the triangles of an AC3D file. A correct import has exactly as many.
///
/// Also finds what the importer would misread in silence: the importer replaces an invalid index by
/// 0, reads the first digits of a number like 1d5 only, misreads what follows an unexpected line,
/// recurses as deep as objects are nested, and subdivides surfaces as often as the file asks.
///
/// Errors: BadInput naming the file and the line, for each of these faults.
[[nodiscard]] Result<std::uint64_t> count_ac3d_triangles(const std::filesystem::path& path);

} // namespace cd
