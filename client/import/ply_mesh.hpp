// Reads PLY files.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// In text (the double nearest to each decimal, whatever type the header names) or binary in either
/// byte order. One element `vertex` with x, y and z, then `face`, or `tristrips` as range scans
/// have them: each list is a strip of triangles that turn to alternate sides, and -1 begins
/// another. Other elements and properties are not read.
///
/// Errors: BadInput naming the file, the line (text) or byte (binary), and the vertex or face.
[[nodiscard]] Result<ImportedMesh> import_ply(const MeshSource& source);

} // namespace cd
