// SIMD kernel of BundleDepths, compiled for every target; plain values in and out.
#pragma once

#include "common/pair/numbers/double_double.hpp"

#include <array>
#include <cstddef>

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
};

/// Triangles, and the lines that pass through them.
struct DepthsOfMany {
    static constexpr std::size_t most = 64;
    using Numbers = std::array<double, most>;

    alignas(64) std::array<std::array<Numbers, 3>, 3> corners; ///< By corner, then by axis.
    alignas(64) std::array<Numbers, 2> across;                 ///< The lines' places.
    alignas(64) Numbers depths;                                ///< NaN where it is unproven.
};

/// Computes the first `count` depths. All slots must hold numbers. Multiplies bounds of errors by
/// `bound_scale`.
void find_depths(const BundleInA& bundle,
                 double bound_scale,
                 std::size_t count,
                 DepthsOfMany& of_many);

} // namespace cd
