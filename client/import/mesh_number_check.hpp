// Finds numbers in mesh files that an importer would read halfway, or as 0.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>
#include <string>

namespace cd {

/// Importers read as much of a word as looks like a number: 1 of "1.#QNAN", as some programs print
/// what is no number.
///
/// Errors: BadInput naming the file and the line or the node, for what check_collada names, and
/// "1.#" with QNAN, SNAN, INF or IND in any file; for an archive, in which other files would stand.
[[nodiscard]] Status check_numbers(const std::filesystem::path& path,
                                   const std::string& lower_extension);

} // namespace cd
