// What the connections of a mesh say: closed or not, how many pieces, what is degenerate.
#pragma once

#include "common/geometry/mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Vertices with equal coordinates count as one vertex throughout.
struct Topology {
    std::uint64_t degenerate = 0; ///< Triangles without area: a repeated corner, or a zero cross
                                  ///< product computed in double.
    std::uint64_t duplicate = 0;  ///< Triangles with the three corners of an earlier one.
    /// Used by one triangle. Triangles that repeat a corner are left out; flat ones of three
    /// corners count, as they may close a seam.
    std::uint64_t boundary_edges = 0;
    std::uint64_t non_manifold_edges = 0; ///< Used by more than two.
    std::uint64_t inconsistent_edges = 0; ///< Used by two in the same direction.
    /// One triangle of each connected component, ascending. Those of degenerate triangles alone
    /// count too.
    std::vector<std::uint32_t> component_triangles;

    /// No boundary, non-manifold or inconsistent edge: the mesh bounds a solid.
    [[nodiscard]] bool is_closed() const {
        return boundary_edges == 0 && non_manifold_edges == 0 && inconsistent_edges == 0;
    }
};

/// Near linear in vertices and triangles.
[[nodiscard]] Topology analyse_topology(const Mesh& mesh);

/// For each triangle the first triangle of its connected component, where only triangles of one
/// kind connect. `kinds` has one for each triangle; empty, all are of one kind. Near linear.
[[nodiscard]] std::vector<std::uint32_t>
first_of_own_component(const Mesh& mesh, std::span<const std::uint32_t> kinds);

} // namespace cd
