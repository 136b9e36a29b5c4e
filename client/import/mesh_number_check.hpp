// Finds numbers in mesh files that an importer would read halfway, or as 0.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>
#include <string>

namespace cd {

/// Importers read as much of a word as looks like a number: 1 of "1.#QNAN" (as some programs print
/// what is no number) and of "1d5".
///
/// Errors: BadInput naming the file and the line or the node, for such coordinates in STL and PLY
/// files in text, what check_collada names, and "1.#" with QNAN, SNAN, INF or IND in
/// any file but binary ones; for an archive, in which other files would stand. AC3D, OBJ and OFF
/// are left to read_text_mesh.
[[nodiscard]] Status check_numbers(const std::filesystem::path& path,
                                   const std::string& lower_extension);

} // namespace cd
