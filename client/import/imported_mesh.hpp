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
    double unit_factor = 1;       ///< Every coordinate is multiplied by it, in double.
    bool rounds_to_float = false; ///< Then each coordinate becomes the nearest float.
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
/// Triangles stand in the canonical order: that of the file's faces, a polygon as `PolygonCutter`
/// cuts it; where the file has nodes, these depth first, each node's meshes, and a mesh that
/// several nodes place counts each time. Formats without groups are one part. Coordinates are the
/// doubles nearest to what the file says, times the unit's factor; the mesh is in floats where
/// these hold all of them. Formats with nodes round once to float, after node transforms and the
/// factor. Corners with equal coordinates share one vertex, in the order of their first use, and
/// vertices that no triangle uses are left out (not so in `.npz`). Degenerate and duplicate
/// triangles are kept.
struct ImportedMesh {
    std::shared_ptr<const Mesh> mesh;
    std::vector<std::string> warnings; ///< A sentence each, naming the file.
    std::uint64_t points_skipped = 0;  ///< Faces of one corner,
    std::uint64_t lines_skipped = 0;   ///< and of two.
};

} // namespace cd
