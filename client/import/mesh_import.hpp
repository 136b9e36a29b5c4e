// Reads mesh files of many formats into canonical meshes.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// STL, OBJ, PLY, OFF, glTF and `.npz` by readers of our own, told apart by the file's ending in
/// upper or lower case; other formats by assimp.
///
/// Errors: BadInput, one line naming the file, and the line, byte or face (from 0): no such file,
/// empty, no mesh, an index out of range, a coordinate that is not finite, or anything else that
/// would lose or change geometry. TooLarge where memory does not suffice.
[[nodiscard]] Result<ImportedMesh> import_mesh(const std::filesystem::path& path,
                                               const ImportOptions& options);

} // namespace cd
