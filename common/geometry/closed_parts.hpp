// Which parts of a mesh bound a solid by themselves.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/part_runs.hpp"

#include <vector>

namespace cd {

/// Returns for each part of a mesh, by its number, whether its triangles alone are closed
/// (`Topology::is_closed`). A part without triangles is not. Takes near-linear time in the number
/// of triangles.
[[nodiscard]] std::vector<bool> closed_parts(const Mesh& mesh, const PartRuns& parts);

} // namespace cd
