// Analyses a mesh's topology: closedness, connected components, degenerate triangles.
#pragma once

#include "common/geometry/mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Facts about a mesh's topology. Vertices with equal coordinates count as one vertex.
struct Topology {
    std::uint64_t degenerate = 0; ///< Triangles without area: a repeated corner, or a zero cross
                                  ///< product computed in double.
    std::uint64_t duplicate = 0;  ///< Triangles with the same corners as an earlier one.
    /// Edges used by one triangle. Triangles that repeat a corner are ignored; flat triangles of
    /// three distinct corners count, because they may close a seam.
    std::uint64_t boundary_edges = 0;
    std::uint64_t non_manifold_edges = 0; ///< Edges used by more than two triangles.
    std::uint64_t inconsistent_edges = 0; ///< Edges used by two triangles in the same direction.
    /// The first triangle of each connected component, ascending. Components of only degenerate
    /// triangles count too.
    std::vector<std::uint32_t> component_triangles;

    /// True if the mesh bounds a solid: no boundary, non-manifold or inconsistent edge.
    [[nodiscard]] bool is_closed() const {
        return boundary_edges == 0 && non_manifold_edges == 0 && inconsistent_edges == 0;
    }
};

/// Takes near-linear time in the number of vertices and triangles.
[[nodiscard]] Topology analyse_topology(const Mesh& mesh);

/// Returns for each triangle the first triangle of its component. Triangles of one kind that share
/// a vertex are connected. `kinds` has one entry per triangle; if empty, all are of one kind. Takes
/// near-linear time.
[[nodiscard]] std::vector<std::uint32_t>
first_of_own_component(const Mesh& mesh, std::span<const std::uint32_t> kinds);

} // namespace cd
