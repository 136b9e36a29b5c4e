// Which axis of a mesh points up.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// With y of the file as z and z as -y, which turns y up to z up. Exact. Errors: those of
/// `Mesh::create`.
[[nodiscard]] Result<ImportedMesh> turned_to_z_up(ImportedMesh imported);

} // namespace cd
