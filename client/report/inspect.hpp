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
    ImportedMesh imported;
    Aabb box;
    std::string unit_guess; ///< "metres", "millimetres", ...; empty if ambiguous.
    Topology topology;
    std::vector<std::string> notes; ///< How the file was interpreted.

    [[nodiscard]] const Mesh& mesh() const { return *imported.mesh; }
};

[[nodiscard]] MeshReport inspect_mesh(const std::string& file, const ImportedMesh& imported);

/// Returns the report for people, in lines with newlines.
[[nodiscard]] std::string to_text(const MeshReport& report);
/// Returns the report as one JSON object with a newline.
[[nodiscard]] std::string to_json(const MeshReport& report);

} // namespace cd
