#include "client/import/gltf/gltf_corners.hpp"

namespace cd {

namespace {

Result<GltfShapes> whole(GltfShapes shapes, bool is_whole, std::uint64_t indices) {
    if (!is_whole) {
        return Error{ErrorCode::BadInput,
                     "its " + std::to_string(indices) +
                         " indices do not make whole triangles or lines"};
    }
    return shapes;
}

} // namespace

Result<GltfShapes> count_shapes(GltfMode mode, std::uint64_t indices) {
    switch (mode) {
    case GltfMode::Points:
        return GltfShapes{0, 0, indices};
    case GltfMode::Lines:
        return whole({0, indices / 2, 0}, indices % 2 == 0, indices);
    case GltfMode::LineLoop:
        return whole({0, indices, 0}, indices != 1, indices);
    case GltfMode::LineStrip:
        return whole({0, indices - (indices > 0 ? 1 : 0), 0}, indices != 1, indices);
    case GltfMode::Triangles:
        return whole({indices / 3, 0, 0}, indices % 3 == 0, indices);
    case GltfMode::TriangleStrip:
    case GltfMode::TriangleFan:
        break;
    }
    return whole({indices < 3 ? 0 : indices - 2, 0, 0}, indices == 0 || indices > 2, indices);
}

std::array<std::uint64_t, 3> corners_of(GltfMode mode, std::uint64_t triangle) {
    switch (mode) {
    case GltfMode::TriangleStrip:
        return triangle % 2 == 0 ? std::array{triangle, triangle + 1, triangle + 2}
                                 : std::array{triangle + 1,
                                              triangle,
                                              triangle + 2}; // Every other triangle is reversed.
    case GltfMode::TriangleFan:
        return {0, triangle + 1, triangle + 2};
    default:
        return {3 * triangle, 3 * triangle + 1, 3 * triangle + 2};
    }
}

} // namespace cd
