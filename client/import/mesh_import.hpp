// Reads mesh files of many formats into canonical meshes.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Any format that assimp reads, and `.npz` with `vertices` (N,3) and `faces` (M,3).
///
/// Errors: BadInput, one line naming the file, and the face (from 0, in the file's order as far as
/// the importer lets it be known) or line: no such file, empty, no mesh, an index out of range, a
/// coordinate that is not finite, or a file of which the importer did not take everything.
[[nodiscard]] Result<ImportedMesh> import_mesh(const std::filesystem::path& path,
                                               const ImportOptions& options);

} // namespace cd
