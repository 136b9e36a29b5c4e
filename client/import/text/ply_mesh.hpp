// Reads PLY files.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Reads text or binary PLY in either byte order. A number in text becomes the nearest double,
/// whatever type the header gives. The file has one element `vertex` with x, y and z, followed by
/// `face`, or by `tristrips`, in which -1 separates strips. Other elements and properties are
/// ignored.
///
/// Errors: BadInput naming the file, the line (text) or byte (binary), and the vertex or face.
[[nodiscard]] Result<ImportedMesh> import_ply(const MeshSource& source);

} // namespace cd
