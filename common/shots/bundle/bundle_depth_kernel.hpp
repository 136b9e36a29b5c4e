// SIMD kernel of BundleDepths, compiled for every target; plain values in and out.
#pragma once

#include "common/pair/numbers/double_double.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// The lines of a bundle in A's coordinates. The line at (y, z) across starts at
/// start + y * across[0] + z * across[1] and ends at that place plus `way`.
struct BundleInA {
    using Vector = std::array<DoubleDouble, 3>;

    Vector start;
    std::array<Vector, 2> across;
    Vector minus_way;       ///< -way.
    double start_error = 0; ///< Bounds the error of each component of a line's start.
    double way_error = 0;   ///< Bounds the error of each component of `minus_way`.
    double way_size = 0;    ///< Bounds its components.
    double length = 0;      ///< Of each line.
    double across_size = 0; ///< Bounds the sum of a line's sizes |y| + |z|.
};

/// Triangles, and the lines that pass through each.
struct DepthsOfMany {
    static constexpr std::size_t triangles_most = 64;
    static constexpr std::size_t lines_most = 512;
    static constexpr std::size_t spare_lines = 8; ///< May be read and written behind the last.
    using OfTriangles = std::array<double, triangles_most>;
    using OfLines = std::array<double, lines_most + spare_lines>;

    alignas(64) std::array<std::array<OfTriangles, 3>, 3> corners; ///< By corner, then by axis.
    /// Where the lines of each triangle begin, and their count at the end.
    std::array<std::size_t, triangles_most + 1> begins;
    /// The triangle of each line, also of spare ones.
    std::array<std::uint32_t, lines_most + spare_lines> triangles;
    alignas(64) std::array<OfLines, 2> across; ///< The lines' places.
    alignas(64) OfLines depths;                ///< NaN where it is unproven.
};

/// Computes the depths of the lines of the first `count` triangles. All slots of corners and lines
/// must hold numbers. Multiplies bounds of errors by `bound_scale`. Returns whether all depths are
/// proven; may return false where they are.
[[nodiscard]] bool
find_depths(const BundleInA& bundle, double bound_scale, std::size_t count, DepthsOfMany& of_many);

} // namespace cd
