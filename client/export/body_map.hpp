// A body's part of a contact map, with a number for each triangle of its mesh.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/result/contact_map.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Returns for each triangle of the mesh the number of scenarios in which it is in contact. Errors:
/// BadInput for a row of a triangle that the mesh does not have.
[[nodiscard]] Result<std::vector<std::uint64_t>>
scenarios_of_triangles(std::span<const TriangleContacts> rows, const Mesh& mesh);

} // namespace cd
