// What a mesh file becomes.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

struct ImportOptions {
    double unit_factor = 1; ///< Every coordinate is multiplied by it, in double.
};

/// A file as the reader of its format gets it. The reader looks at no other byte of the file, and
/// names the path in its errors.
struct MeshSource {
    const std::filesystem::path& path;
    std::string_view bytes; ///< All of the file.
    const ImportOptions& options;

    /// BadInput: "PATH: DETAIL".
    [[nodiscard]] Error refusal(const std::string& detail) const {
        return {ErrorCode::BadInput, path.string() + ": " + detail};
    }
    /// BadInput: "PATH:LINE: DETAIL". Lines count from 1.
    [[nodiscard]] Error refusal(std::uint64_t line, const std::string& detail) const {
        return {ErrorCode::BadInput, path.string() + ":" + std::to_string(line) + ": " + detail};
    }
};

/// The part of a format without groups. Not the file's name: names are hashed with the mesh, and
/// one geometry under two file names is one mesh.
inline constexpr const char* nameless_part = "mesh";

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

} // namespace cd
