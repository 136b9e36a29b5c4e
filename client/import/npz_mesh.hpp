// Reads meshes from NumPy's .npz archives.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Reads the arrays `vertices` (N,3) and `faces` (M,3). Doubles stay doubles.
///
/// Errors: BadInput naming the file, and the face or vertex.
[[nodiscard]] Result<ImportedMesh> import_npz(const std::filesystem::path& path,
                                              const ImportOptions& options);

} // namespace cd
