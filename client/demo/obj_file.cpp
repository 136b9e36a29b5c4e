#include "client/demo/obj_file.hpp"

#include <fmt/core.h>

#include <iterator>

namespace cd {

std::string obj_text(const Mesh& mesh) {
    std::string text;
    const auto out = std::back_inserter(text);
    for (const Vec3& vertex : mesh.vertices()) {
        fmt::format_to(out, "v {} {} {}\n", vertex.x(), vertex.y(), vertex.z());
    }
    for (const Part& part : mesh.parts()) {
        fmt::format_to(out, "g {}\n", part.name);
        for (std::uint32_t i = part.triangles_begin; i < part.triangles_end; ++i) {
            const Triangle& triangle = mesh.triangles()[i];
            fmt::format_to(out, "f {} {} {}\n", triangle[0] + 1, triangle[1] + 1, triangle[2] + 1);
        }
    }
    return text;
}

} // namespace cd
