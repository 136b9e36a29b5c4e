// Reads meshes from NumPy's .npz archives.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Reads the arrays `vertices` (N,3) and `faces` (M,3). Doubles stay doubles. Parts are optional:
/// `parts` (P,3) of u4 has the first triangle, the triangle after the last, and the bytes of the
/// name; `part_names` of u1 has all names without separators.
///
/// Errors: BadInput naming the file, and the face, vertex or part.
[[nodiscard]] Result<ImportedMesh> import_npz(const std::filesystem::path& path,
                                              const ImportOptions& options);

} // namespace cd
