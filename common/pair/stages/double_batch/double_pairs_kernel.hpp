// SIMD kernel of DoubleTrianglePairs, compiled for every target; plain values in and out.
#pragma once

#include "common/pair/stages/double_batch/corners_of_many.hpp"
#include "common/pair/stages/float/rounded_poses.hpp"

#include <cstddef>
#include <cstdint>

namespace cd {

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
