// Reads an AC3D file by itself, to hold the importer against it.
#pragma once

#include "client/import/mesh_text_check.hpp"

namespace cd {

[[nodiscard]] bool is_ac3d(const std::filesystem::path& path, const std::string& lower_extension);

/// Only the triangles of its surfaces are counted: parts have transforms of their own.
///
/// The importer takes vertex 0 for an index that names none, half of a number like 1d5, and, where
/// a line is not what it expects, the rest of the file for something else; it goes as deep as the
/// objects are nested and subdivides surfaces as often as the file wants.
///
/// Errors: BadInput naming the file and the line, for each of these.
[[nodiscard]] Result<TextMesh> read_ac3d(const std::filesystem::path& path);

} // namespace cd
