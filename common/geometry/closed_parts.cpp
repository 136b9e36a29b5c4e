#include "common/geometry/closed_parts.hpp"

#include "common/geometry/topology.hpp"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace cd {

namespace {

/// Returns a mesh of some triangles of another one.
Mesh cut_out(const Mesh& mesh, const std::vector<std::uint32_t>& triangles) {
    MeshArrays arrays;
    std::unordered_map<std::uint32_t, std::uint32_t> numbers;
    for (const std::uint32_t triangle : triangles) {
        Triangle renumbered{};
        for (std::size_t corner = 0; corner < renumbered.size(); ++corner) {
            const std::uint32_t vertex = mesh.triangles()[triangle][corner];
            const auto next = static_cast<std::uint32_t>(arrays.vertices.size());
            const auto [number, is_new] = numbers.try_emplace(vertex, next);
            if (is_new) {
                arrays.vertices.push_back(mesh.vertices()[vertex]);
            }
            renumbered[corner] = number->second;
        }
        arrays.triangles.push_back(renumbered);
    }
    return Mesh::create(std::move(arrays)).value();
}

} // namespace

std::vector<bool> closed_parts(const Mesh& mesh, const PartRuns& parts) {
    std::vector<std::vector<std::uint32_t>> triangles(parts.count());
    PartCursor cursor(parts);
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        triangles[cursor.part_of(i)].push_back(i);
    }
    std::vector<bool> are_closed;
    are_closed.reserve(triangles.size());
    for (const std::vector<std::uint32_t>& of_part : triangles) {
        are_closed.push_back(!of_part.empty() &&
                             analyse_topology(cut_out(mesh, of_part)).is_closed());
    }
    return are_closed;
}

} // namespace cd
