// Reads mesh files with assimp, in this process. No other file uses assimp.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Reads any format that assimp reads. A hostile file may crash or hang assimp, and so this
/// process; `import_with_assimp` is safe from that.
///
/// Errors: BadInput naming the file, and the face if assimp reports it.
[[nodiscard]] Result<ImportedMesh> read_with_assimp(const std::filesystem::path& path,
                                                    const ImportOptions& options);

/// Returns the version of assimp, such as "5.2.4".
[[nodiscard]] std::string assimp_version();

} // namespace cd
