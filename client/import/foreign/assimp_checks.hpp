// Finds content that assimp would misread without an error.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>
#include <string>

namespace cd {

/// Checks a file before assimp reads it. Some programs print NaN as "1.#QNAN", which assimp would
/// read as 1.
///
/// Errors: BadInput naming the file and the line or node, for whatever `check_collada` refuses; for
/// "1.#" followed by QNAN, SNAN, INF or IND in any file; for an archive other than a 3MF file.
[[nodiscard]] Status check_for_assimp(const std::filesystem::path& path,
                                      const std::string& lower_extension);

} // namespace cd
