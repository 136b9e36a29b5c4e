// Finds what an importer would misread, pass over, or fall over, in a COLLADA file.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>
#include <string>

namespace cd {

/// True where the importer would find a COLLADA document, whatever the file's name.
[[nodiscard]] bool is_collada(const std::string& text);

/// The importer takes half of a number like 1d5 and vertex 0 for a negative index, reads on without
/// end where an index is none and beyond the end of an array that is too short, takes only the
/// first piece of an element's text, goes as deep as elements are nested, and passes over an
/// instance of what is not there, convex hulls, skins and morphs.
///
/// Errors: BadInput naming the file and the line, for XML that is not well-formed, and for each of
/// these in what shapes the mesh: coordinates, indices, transforms, the unit, counts, offsets,
/// strides and instances.
[[nodiscard]] Status check_collada(const std::filesystem::path& path, const std::string& text);

} // namespace cd
