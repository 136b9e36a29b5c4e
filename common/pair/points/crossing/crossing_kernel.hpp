// SIMD kernel of CrossingPoints, compiled for every target; plain values in and out.
#pragma once

#include "common/pair/stages/double_batch/corners_of_many.hpp"

#include <array>
#include <cstddef>

namespace cd {

/// A body's pose as LocalMap has it, in plain values.
struct CrossingPose {
    using Matrix = std::array<std::array<double, 3>, 3>;

    /// Stands for LocalMap's `plain`.
    struct Row {
        bool is_plain = false;
        std::size_t column = 0;
        double entry = 0;
    };

    Matrix high{};
    Matrix low{};
    std::array<double, 3> translation{};
    double largest = 0;
    std::array<Row, 3> rows{};

    [[nodiscard]] bool has_plain_row() const {
        return rows[0].is_plain || rows[1].is_plain || rows[2].is_plain;
    }
};

/// Origins and both ends of the shared segments of eight pairs, by axis and pair.
struct CrossingsOfMany {
    using Vectors = std::array<std::array<double, CornersOfMany::pairs>, 3>;

    alignas(64) Vectors origin;
    alignas(64) std::array<Vectors, 2> ends;
    alignas(64) std::array<double, CornersOfMany::pairs> proven; ///< 1 if proven, else 0.
};

/// Computes the first `count` pairs. Multiplies all error bounds by `bound_scale`. All eight slots
/// must hold numbers.
void find_crossings(const CrossingPose& a,
                    const CrossingPose& b,
                    double bound_scale,
                    const CornersOfMany& corners,
                    std::size_t count,
                    CrossingsOfMany& found);

} // namespace cd
