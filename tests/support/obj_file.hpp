// Writes meshes as OBJ files.
#pragma once

#include "common/geometry/mesh.hpp"
#include "tests/support/process.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace cd::tests {

/// Writes coordinates with six decimals, and each part as a group of that name.
inline void write_obj(const std::filesystem::path& path, const Mesh& mesh) {
    std::string text;
    for (const Vec3& v : mesh.vertices()) {
        text += "v " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " +
                std::to_string(v.z()) + "\n";
    }
    auto part = mesh.parts().begin();
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        for (; part != mesh.parts().end() && part->triangles_begin == i; ++part) {
            text += "g " + part->name + "\n";
        }
        const Triangle& t = mesh.triangles()[i];
        text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
                std::to_string(t[2] + 1) + "\n";
    }
    write_text(path, text);
}

} // namespace cd::tests
