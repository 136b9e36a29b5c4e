// Reads OFF files.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// OFF in text, also with normals, colours or texture coordinates of vertices (NOFF, COFF, STOFF
/// and their combinations), which are not read. Each vertex and each face has a line of its own;
/// comments begin with '#'.
///
/// Errors: BadInput naming the file, the line, and the vertex or face, also for binary files and
/// for vertices of other than three dimensions (4OFF, nOFF).
[[nodiscard]] Result<ImportedMesh> import_off(const MeshSource& source);

} // namespace cd
