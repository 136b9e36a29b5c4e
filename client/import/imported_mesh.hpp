// The result of importing a mesh file.
#pragma once

#include "common/core/errors.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/geometry/mesh.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// The unit and the up axis that a mesh file declares. Members are empty or 0 where neither the
/// file nor its format declares them.
struct DeclaredFrame {
    std::string unit;  ///< The unit's name in the file: "inch".
    double metres = 0; ///< Length of one unit in metres.
    std::string up;    ///< "X", "Y" or "Z".

    friend bool operator==(const DeclaredFrame&, const DeclaredFrame&) = default;
};

struct ImportOptions {
    double unit_factor = 1; ///< Multiplies all coordinates, in double.
    /// The job's unit. If the file declares a unit, coordinates are converted from that to the
    /// job's unit, and `unit_factor` is not used. Empty: the file's unit is ignored.
    std::string declared_unit_to = {};
    bool is_y_up = false; ///< The file's y becomes z, and its z becomes -y.
    /// This point, in the mesh's unit and after the turn of `is_y_up`, becomes the origin.
    std::array<double, 3> origin = {};
    bool rounds_to_float = false; ///< Each coordinate becomes the nearest float.
    StopCheck is_stopped = {};    ///< Once it returns true, an import in a child process ends.
};

/// Returns the factor of all coordinates: from the declared unit, or else `unit_factor`.
[[nodiscard]] double factor_of(const ImportOptions& options, const DeclaredFrame& declared);

/// The input of a format's reader, which names the path in its errors.
struct MeshSource {
    const std::filesystem::path& path;
    std::string_view bytes; ///< All of the file.
    const ImportOptions& options;

    /// Returns the error BadInput "PATH: DETAIL".
    [[nodiscard]] Error refusal(const std::string& detail) const {
        return bad_input(path.string() + ": " + detail);
    }
    /// Returns the error BadInput "PATH:LINE: DETAIL". Lines count from 1.
    [[nodiscard]] Error refusal(std::uint64_t line, const std::string& detail) const {
        return bad_input(path.string() + ":" + std::to_string(line) + ": " + detail);
    }
};

/// The name of the only part of a format without groups. It is not the file's name, since part
/// names are hashed with the mesh, and the same geometry under two file names is one mesh.
inline constexpr const char* nameless_part = "mesh";

/// A mesh with the geometry of its file, except for the changes listed here.
///
/// Triangles are in the order of the file's faces, or for formats with nodes in the order of the
/// nodes, depth first. A format without groups gives one part. Formats with nodes apply transforms
/// and the unit's factor in double and round once to float. In other formats a coordinate is the
/// double nearest to the number in the file, times the factor; the mesh uses floats if they hold
/// all coordinates. Equal corners share one vertex, numbered by first use, and unused vertices are
/// dropped (except in `.npz`). Degenerate and duplicate triangles are kept. An `origin` is
/// subtracted in double from the coordinates described so far, and rounded once; the mesh again
/// uses floats if they hold all differences. Vertices that become equal stay apart.
struct ImportedMesh {
    std::shared_ptr<const Mesh> mesh;
    DeclaredFrame declared;            ///< As in the file; its up axis does not turn the mesh.
    bool is_by_assimp = false;         ///< Coordinates are within one float step of the file's.
    bool is_rounded = false;           ///< Rounded to floats on request; the file has more digits.
    std::vector<std::string> warnings; ///< A sentence each, naming the file.
    std::uint64_t points_skipped = 0;  ///< Number of faces with one corner.
    std::uint64_t lines_skipped = 0;   ///< Number of faces with two corners.
};

/// Returns notes such as "unit inch, from the file" or "up axis Y, from the file; not turned".
/// `unit` is the unit that the user gave instead of the file's, or empty.
[[nodiscard]] std::vector<std::string>
import_notes(const ImportedMesh& imported, const std::string& unit, bool is_y_up);

} // namespace cd
