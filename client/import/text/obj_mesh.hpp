// Reads Wavefront OBJ files.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Reads polygons and their groups. A part begins at each `o`, at each `g` whose name differs from
/// the one before, and at each change of material (`usemtl`). A part is named after the object or
/// group; a part that begins at a change of material is named after the group, or else the
/// material. Names may contain blanks. Points and lines are skipped and counted. Normals, texture
/// coordinates and smoothing are ignored.
///
/// Errors: BadInput naming the file and the line, also for unsupported statements: free-form curves
/// and surfaces, `call`, keywords in upper case.
[[nodiscard]] Result<ImportedMesh> import_obj(const MeshSource& source);

} // namespace cd
