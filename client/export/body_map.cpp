#include "client/export/body_map.hpp"

#include "common/core/errors.hpp"

#include <string>

namespace cd {

Result<std::vector<std::uint64_t>> scenarios_of_triangles(std::span<const TriangleContacts> rows,
                                                          const Mesh& mesh) {
    std::vector<std::uint64_t> scenarios(mesh.triangles().size());
    for (const TriangleContacts& row : rows) {
        if (row.triangle >= scenarios.size()) {
            return bad_input("the contact map has triangle " + std::to_string(row.triangle) +
                             " of a mesh with " + std::to_string(scenarios.size()) +
                             "; run the job again");
        }
        scenarios[row.triangle] = row.scenarios;
    }
    return scenarios;
}

} // namespace cd
