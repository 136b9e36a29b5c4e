// SIMD kernel of DoubleTrianglePairs, compiled for every target; plain values in and out.
#pragma once

#include "common/pair/poses/rounded_poses.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// The unposed corners of eight pairs, by corner, axis and pair.
struct CornersOfMany {
    static constexpr std::size_t pairs = 8;
    using Triangles = std::array<std::array<std::array<double, pairs>, 3>, 3>;

    alignas(64) Triangles a;
    alignas(64) Triangles b;
};

/// Marks a pair that doubles leave undecided.
inline constexpr std::uint8_t undecided_pair = 4;

/// Writes the proven PairClass, or `undecided_pair`, of the first `count` pairs. Multiplies all
/// error bounds by `bound_scale`. All eight slots must hold numbers.
void classify_in_doubles(const RoundedPoses& poses,
                         double bound_scale,
                         const CornersOfMany& corners,
                         std::size_t count,
                         std::uint8_t* classes);

} // namespace cd
