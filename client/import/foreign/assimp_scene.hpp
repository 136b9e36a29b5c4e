// Reads mesh files with assimp, in this process. The only user of assimp.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Reads any format that assimp reads. A hostile file may crash or hang assimp and this process;
/// `import_with_assimp` is safe from that.
///
/// Errors: BadInput naming the file, and the face if assimp reports it.
[[nodiscard]] Result<ImportedMesh> read_with_assimp(const std::filesystem::path& path,
                                                    const ImportOptions& options);

/// The version of assimp, such as "5.2.4".
[[nodiscard]] std::string assimp_version();

} // namespace cd
