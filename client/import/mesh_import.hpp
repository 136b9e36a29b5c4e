// Reads mesh files of many formats into canonical meshes.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Reads STL, OBJ, PLY, OFF, glTF and `.npz` with native readers, chosen by the file's extension in
/// upper or lower case, and other formats with assimp.
///
/// Errors: BadInput, one line naming the file and the line, byte or face (from 0), for a missing or
/// empty file, a file without a mesh, an index out of range, a coordinate that is not finite, and
/// anything else that would lose or change geometry. TooLarge if memory does not suffice.
[[nodiscard]] Result<ImportedMesh> import_mesh(const std::filesystem::path& path,
                                               const ImportOptions& options);

} // namespace cd
