// What people are told of how a mesh file was taken.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// "unit inch, from the file", "up axis Y, from the file; not turned", "read by assimp: ...".
/// `unit` is the one that was asked for in place of the file's, or empty.
[[nodiscard]] std::vector<std::string>
import_notes(const ImportedMesh& imported, const std::string& unit, bool is_y_up);

} // namespace cd
