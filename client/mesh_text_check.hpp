// Holds what the importer made of an OBJ or OFF file against the file itself.
#pragma once

#include "client/mesh_import.hpp"

namespace cd {

/// The importer drops an OBJ vertex whose number it cannot read and replaces an OFF index that is
/// out of range, without a word. So for these two formats: every index of a face must name a
/// vertex, the number of triangles must be that of the file's faces, and every vertex that a face
/// uses must be in the mesh, up to the importer's rounding of decimals. Other formats pass.
///
/// Errors: BadInput naming the file and the line or face.
[[nodiscard]] Status check_against_text(const std::filesystem::path& path,
                                        const std::string& lower_extension,
                                        const ImportOptions& options,
                                        const Mesh& mesh);

} // namespace cd
