// Holds the mesh that assimp makes of an AC3D file against the file itself.
#pragma once

#include "client/import/mesh_import.hpp"

#include <optional>

namespace cd {

/// What a text file says, before any importer.
struct TextMesh {
    std::vector<Vec3> vertices;
    std::vector<std::uint64_t> vertex_lines; ///< From 1; 0 where lines do not count.
    std::vector<bool> used;
    std::uint64_t triangles = 0; ///< Of all its polygons.
};

/// Reads an AC3D file by itself. Nothing for other formats.
///
/// Errors: BadInput naming the file and the line.
[[nodiscard]] Result<std::optional<TextMesh>> read_text_mesh(const std::filesystem::path& path,
                                                             const std::string& lower_extension);

/// The number of triangles must be that of the file's faces, and every vertex that a face uses must
/// be in the mesh, up to assimp's rounding of decimals.
///
/// Errors: BadInput naming the file and the line or face.
[[nodiscard]] Status check_against_text(const std::filesystem::path& path,
                                        const TextMesh& text,
                                        const ImportOptions& options,
                                        const Mesh& mesh);

} // namespace cd
