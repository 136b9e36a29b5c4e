// What a mesh file becomes.
#pragma once

#include "client/import/declared_frame.hpp"
#include "common/core/result.hpp"
#include "common/core/stop_check.hpp"
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
    /// The job's unit: a unit that the file declares is converted to it, in place of `unit_factor`.
    /// Empty: what the file declares changes nothing.
    std::string declared_unit_to = {};
    bool is_y_up = false;         ///< y of the file becomes z, and z becomes -y.
    bool rounds_to_float = false; ///< Each coordinate becomes the nearest float.
    StopCheck is_stopped = {};    ///< Ends the reading of formats that take a process of their own.
};

/// What coordinates are multiplied by.
[[nodiscard]] double factor_of(const ImportOptions& options, const DeclaredFrame& declared);

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
/// Triangles are in the order of the file's faces, or of its nodes depth first, each time that one
/// places a mesh. Formats without groups are one part. Formats with nodes apply transforms and the
/// unit's factor in double and round once to float. In other formats coordinates are the doubles
/// nearest to what the file says, times the factor; in floats where these hold all of them. Equal
/// corners share one vertex, in the order of their first use; vertices that no triangle uses are
/// left out (not in `.npz`). Degenerate and duplicate triangles are kept.
struct ImportedMesh {
    std::shared_ptr<const Mesh> mesh;
    DeclaredFrame declared;            ///< Applied to the mesh is no more than its unit.
    bool is_by_assimp = false;         ///< Coordinates are within one float step of the file's.
    bool is_rounded = false;           ///< To floats, as asked; the file has more digits.
    std::vector<std::string> warnings; ///< A sentence each, naming the file.
    std::uint64_t points_skipped = 0;  ///< Faces of one corner,
    std::uint64_t lines_skipped = 0;   ///< and of two.
};

} // namespace cd
