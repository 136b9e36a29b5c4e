// Scenes for tests: bodies with meshes of named parts.
#pragma once

#include "client/scene/scene_bodies.hpp"
#include "tests/support/shapes.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

/// Makes a mesh with these parts, each with so many triangles. Triangles of the part "" are of no
/// part.
inline std::shared_ptr<const Mesh>
mesh_of_parts(const std::vector<std::pair<std::string, std::uint32_t>>& parts) {
    MeshArrays arrays;
    for (const auto& [name, triangles] : parts) {
        const auto begin = static_cast<std::uint32_t>(arrays.triangles.size());
        for (std::uint32_t i = 0; i < triangles; ++i) {
            const auto first = static_cast<std::uint32_t>(arrays.vertices.size());
            const double x = first;
            arrays.vertices.insert(arrays.vertices.end(),
                                   {Vec3(x, 0, 0), Vec3(x + 1, 0, 0), Vec3(x, 1, 0)});
            arrays.triangles.push_back({first, first + 1, first + 2});
        }
        if (!name.empty()) {
            arrays.parts.push_back({name, begin, begin + triangles});
        }
    }
    return share(Mesh::create(std::move(arrays)).value());
}

/// Makes an entry of [bodies] with the mesh file NAME.obj.
inline SceneBodySpec body_entry(const std::string& name, const std::string& group = "") {
    SceneBodySpec spec;
    spec.name = name;
    spec.mesh.path = name + ".obj";
    spec.group = group;
    return spec;
}

} // namespace cd::tests
