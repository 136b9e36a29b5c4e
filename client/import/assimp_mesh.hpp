// Mesh files of the formats that have no reader of our own. The only user of assimp.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Any format that assimp reads.
///
/// Errors: BadInput naming the file, and the face as far as assimp lets it be known.
[[nodiscard]] Result<ImportedMesh> import_with_assimp(const std::filesystem::path& path,
                                                      const ImportOptions& options);

} // namespace cd
