// Finds content of a COLLADA file that the importer would misread, ignore or crash on.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>
#include <string>

namespace cd {

/// True if the importer would read the text as COLLADA, whatever the file's name.
[[nodiscard]] bool is_collada(const std::string& text);

/// Checks what the importer does not check. The importer takes 1 for a number like 1d5 and vertex 0
/// for a negative index, loops on text that is not an index, reads beyond the end of a short array,
/// reads only the first piece of an element's text, recurses as deep as elements are nested, and
/// ignores instances that refer to nothing, convex hulls, skins and morphs.
///
/// Errors: BadInput naming the file and the line, for XML that is not well-formed and for all such
/// content in coordinates, indices, transforms, the unit, counts, offsets, strides and instances.
[[nodiscard]] Status check_collada(const std::filesystem::path& path, const std::string& text);

} // namespace cd
