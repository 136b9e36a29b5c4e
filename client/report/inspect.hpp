// The report of `cdctl inspect MESH`.
#pragma once

#include "client/import/mesh_import.hpp"
#include "common/geometry/aabb.hpp"
#include "common/geometry/topology.hpp"

#include <string>
#include <vector>

namespace cd {

struct MeshReport {
    std::string file;
    std::uint64_t triangles = 0;
    std::uint64_t vertices = 0;
    Precision precision = Precision::Float;
    Aabb box;
    std::string unit_guess; ///< "metres", "millimetres", ...; empty if ambiguous.
    Topology topology;
    std::vector<Part> parts;
    std::uint64_t points_skipped = 0;
    std::uint64_t lines_skipped = 0;
    DeclaredFrame declared;         ///< Unit and up axis declared in the file.
    std::vector<std::string> notes; ///< How the file was interpreted.
    std::vector<std::string> warnings;
    Sha256 hash;
};

[[nodiscard]] MeshReport inspect_mesh(const std::string& file, const ImportedMesh& imported);

/// Lines for people, each with a newline.
[[nodiscard]] std::string to_text(const MeshReport& report);
/// One JSON object with a newline.
[[nodiscard]] std::string to_json(const MeshReport& report);

} // namespace cd
