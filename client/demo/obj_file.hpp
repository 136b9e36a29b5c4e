// Writes meshes as Wavefront OBJ.
#pragma once

#include "common/geometry/mesh.hpp"

#include <string>

namespace cd {

/// Returns a mesh as text, with a group for each part. Triangles outside of parts are left out.
/// Reading it gives equal triangles and parts. A part's name must not contain a line break.
[[nodiscard]] std::string obj_text(const Mesh& mesh);

} // namespace cd
