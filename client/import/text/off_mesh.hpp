// Reads OFF files.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Reads OFF in text form. Normals, colours and texture coordinates of vertices (NOFF, COFF, STOFF
/// and their combinations) are ignored. Each vertex and each face is on its own line; comments
/// begin with '#'.
///
/// Errors: BadInput naming the file, the line, and the vertex or face, also for binary files and
/// for vertices with other than three coordinates (4OFF, nOFF).
[[nodiscard]] Result<ImportedMesh> import_off(const MeshSource& source);

} // namespace cd
