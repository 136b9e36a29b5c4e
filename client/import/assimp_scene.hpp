// Reads mesh files with assimp, in this process. The only user of assimp.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Any format that assimp reads. Files of hostile content may crash assimp, or keep it busy for
/// ever; `import_with_assimp` is safe from that.
///
/// Errors: BadInput naming the file, and the face as far as assimp lets it be known.
[[nodiscard]] Result<ImportedMesh> read_with_assimp(const std::filesystem::path& path,
                                                    const ImportOptions& options);

/// "5.2.4".
[[nodiscard]] std::string assimp_version();

} // namespace cd
