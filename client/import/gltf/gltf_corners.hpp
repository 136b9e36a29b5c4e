// The triangles of a glTF primitive, as positions in its list of indices.
#pragma once

#include "client/import/gltf/gltf_document.hpp"

#include <array>
#include <cstdint>

namespace cd {

/// Numbers of triangles, lines and points in a primitive.
struct GltfShapes {
    std::uint64_t triangles = 0;
    std::uint64_t lines = 0;
    std::uint64_t points = 0;
};
/// Counts a primitive's elements. Errors: BadInput if the number of indices leaves a triangle or a
/// line incomplete.
[[nodiscard]] Result<GltfShapes> count_shapes(GltfMode mode, std::uint64_t indices);

/// The positions of a triangle's corners in the list of indices, ordered so that all triangles of a
/// strip or a fan face the same way (section 3.7.2.1).
[[nodiscard]] std::array<std::uint64_t, 3> corners_of(GltfMode mode, std::uint64_t triangle);

} // namespace cd
