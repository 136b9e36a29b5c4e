// Reads Wavefront OBJ files.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Polygons and their groups. Each `o`, each `g` with another name than the one before, and each
/// change of material within them (`usemtl`) begins a part. It has the name of the object or group;
/// after a change of material that of the group, or else of the material. Names keep their blanks.
/// Points and lines are counted. Normals, texture coordinates and smoothing are not read.
///
/// Errors: BadInput naming the file and the line, also for statements that are not known here:
/// free-form curves and surfaces, `call`, keywords in upper case.
[[nodiscard]] Result<ImportedMesh> import_obj(const MeshSource& source);

} // namespace cd
