// Notes for the user about how a mesh file was interpreted.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Notes such as "unit inch, from the file", "up axis Y, from the file; not turned" and "read by
/// assimp: ...". `unit` is the unit that the user gave instead of the file's, or empty.
[[nodiscard]] std::vector<std::string>
import_notes(const ImportedMesh& imported, const std::string& unit, bool is_y_up);

} // namespace cd
