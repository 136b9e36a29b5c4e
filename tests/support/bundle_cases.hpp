// Bundles of lines parallel to an axis that aim at the corners, edges and faces of triangles.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"
#include "common/shots/line_hit.hpp"

#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace cd::tests {

/// Triangles of A, and lines of B that are parallel to an axis.
struct BundleCase {
    Mesh body;
    std::vector<Segment> lines;
    PosePair poses;
};

/// Returns the names of the kinds: those of `shot_makers`, with other lines.
[[nodiscard]] std::vector<std::string> bundle_kinds();

/// Makes a case of some kind. B's pose is a rotation and a translation.
[[nodiscard]] BundleCase make_bundle_case(const std::string& kind, std::mt19937_64& random);

/// Makes a mesh of the segments (p, q, q).
[[nodiscard]] Mesh mesh_of(const std::vector<Segment>& lines);

/// Makes the lines of a grid of `counts`, with the given ends along an axis; each line moves by up
/// to `jitter` of a cell.
[[nodiscard]] std::vector<Segment> grid_lines(std::mt19937_64& random,
                                              std::size_t axis,
                                              const std::array<int, 2>& counts,
                                              double spacing,
                                              double jitter,
                                              const std::array<double, 2>& ends);

} // namespace cd::tests
