// The corners of several pairs, arranged for SIMD kernels that compute one pair per lane.
#pragma once

#include "common/geometry/types.hpp"

#include <array>
#include <cstddef>

namespace cd {

/// The unposed corners of eight pairs, by corner, axis and pair.
struct CornersOfMany {
    static constexpr std::size_t pairs = 8;
    using Triangles = std::array<std::array<std::array<double, pairs>, 3>, 3>;

    alignas(64) Triangles a;
    alignas(64) Triangles b;

    void set(std::size_t place, const Corners& of_a, const Corners& of_b) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                a[i][k][place] = of_a[i][static_cast<int>(k)];
                b[i][k][place] = of_b[i][static_cast<int>(k)];
            }
        }
    }
};

} // namespace cd
