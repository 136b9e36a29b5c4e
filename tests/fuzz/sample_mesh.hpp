// The mesh of the corpus's trees.
#pragma once

#include "common/geometry/mesh.hpp"

#include <memory>

namespace cd::fuzz {

/// Makes a curved sheet of 50 triangles.
inline std::shared_ptr<const Mesh> sample_mesh() {
    constexpr std::uint32_t side = 6;
    MeshArrays arrays;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        arrays.vertices.emplace_back(i % side, i / side, i % 3); // NOLINT: whole numbers.
        if (i % side + 1 < side && i / side + 1 < side) {
            arrays.triangles.push_back({i, i + 1, i + side});
            arrays.triangles.push_back({i + 1, i + side + 1, i + side});
        }
    }
    arrays.precision = Precision::Float;
    return std::make_shared<const Mesh>(Mesh::create(std::move(arrays)).value());
}

} // namespace cd::fuzz
