// Turns a mesh from y up to z up.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Maps y to z and z to -y, exactly. Errors: those of `Mesh::create`.
[[nodiscard]] Result<ImportedMesh> turned_to_z_up(ImportedMesh imported);

} // namespace cd
