// Reads mesh files of many formats into canonical meshes. The only user of assimp.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace cd {

struct ImportOptions {
    double unit_factor = 1; ///< Every coordinate is multiplied by it, in double.
};

/// A mesh as its file has it: nothing merged, removed or reordered but what this comment says.
///
/// Triangles stand in the canonical order: the file's nodes depth first, each node's meshes, each
/// mesh's faces, a polygon as the importer triangulates it; a mesh that several nodes place counts
/// each time. Each node's mesh is a part; formats without groups are one part. Node transforms and
/// the unit's factor are applied in double and rounded once to float; `.npz` keeps doubles. Corners
/// with equal coordinates share one vertex, in the order of their first use, and vertices that no
/// triangle uses are left out. Degenerate and duplicate triangles are kept.
struct ImportedMesh {
    std::shared_ptr<const Mesh> mesh;
    std::vector<std::string> warnings; ///< A sentence each, naming the file.
    std::uint64_t points_skipped = 0;  ///< Faces of one corner,
    std::uint64_t lines_skipped = 0;   ///< and of two.
};

/// Any format that assimp reads, and `.npz` with `vertices` (N,3) and `faces` (M,3).
///
/// Errors: BadInput, one line naming the file, and the face (from 0, in the file's order as far as
/// the importer lets it be known) or line: no such file, empty, no mesh, an index out of range, a
/// coordinate that is not finite, or a file of which the importer did not take everything.
[[nodiscard]] Result<ImportedMesh> import_mesh(const std::filesystem::path& path,
                                               const ImportOptions& options);

} // namespace cd
