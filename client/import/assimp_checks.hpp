// Finds what assimp would take from a file without a word, and wrongly.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>
#include <string>

namespace cd {

/// assimp reads as much of a word as looks like a number: 1 of "1.#QNAN", as some programs print
/// what is no number.
///
/// Errors: BadInput naming the file and the line or the node, for what check_collada names, and
/// "1.#" with QNAN, SNAN, INF or IND in any file; for an archive, in which other files would stand.
[[nodiscard]] Status check_for_assimp(const std::filesystem::path& path,
                                      const std::string& lower_extension);

} // namespace cd
