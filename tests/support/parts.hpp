// Gives meshes parts.
#pragma once

#include "common/geometry/mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

[[nodiscard]] inline Mesh with_parts(const Mesh& mesh, std::vector<Part> parts) {
    return Mesh::create({mesh.vertices(), mesh.triangles(), std::move(parts), mesh.precision()})
        .value();
}

/// Cuts a mesh into `count` named parts of about equal numbers of triangles.
[[nodiscard]] inline Mesh in_parts(const Mesh& mesh, std::uint32_t count) {
    const auto triangles = static_cast<std::uint32_t>(mesh.triangles().size());
    std::vector<Part> parts;
    for (std::uint32_t i = 0; i < count; ++i) {
        parts.push_back(
            {"part " + std::to_string(i), i * triangles / count, (i + 1) * triangles / count});
    }
    return with_parts(mesh, std::move(parts));
}

} // namespace cd::tests
