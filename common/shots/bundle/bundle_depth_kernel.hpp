// SIMD kernel of BundleDepths, compiled for every target; plain values in and out.
#pragma once

#include "common/geometry/triangle_blocks.hpp"
#include "common/pair/numbers/double_double.hpp"
#include "common/shots/bundle/parallel_lines.hpp"

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
    static constexpr std::size_t spare = 8; ///< May be read and written behind the last.
    template <class T>
    using OfLines = std::array<T, lines_most + spare>;

    std::size_t count = 0; ///< Of triangles.
    std::array<std::uint32_t, triangles_most + spare> slots;
    /// Where the lines of each triangle begin, and their count at the end.
    std::array<std::size_t, triangles_most + 1> begins;
    OfLines<std::uint32_t> triangles;   ///< The number of each line's triangle among `slots`.
    OfLines<std::uint32_t> lines;       ///< Places in `LineRows`.
    alignas(64) OfLines<double> depths; ///< NaN where it is unproven.
};

/// Computes the depths of lines. Spare slots and lines must be valid indices. Multiplies error
/// bounds by `bound_scale`. If it returns true, all depths are proven; the converse does not hold.
[[nodiscard]] bool find_depths(const BundleInA& bundle,
                               double bound_scale,
                               const TriangleBlocks& blocks,
                               const LineRows& rows,
                               DepthsOfMany& of_many);

} // namespace cd
