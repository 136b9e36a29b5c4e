// Rounds the coordinates of a mesh to floats.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// The mesh with each coordinate rounded once to the nearest float. Triangles keep their numbers
/// and parts; positions that become equal share one vertex, and vertices that no triangle uses are
/// left out. A mesh in floats is returned as it is. Errors: BadInput naming the file and a triangle
/// with a coordinate that no float holds.
[[nodiscard]] Result<ImportedMesh> rounded_to_floats(const std::filesystem::path& path,
                                                     ImportedMesh imported);

} // namespace cd
