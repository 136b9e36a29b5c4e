// SIMD kernel of FloatDistance, compiled for every target; plain values in and out.
#pragma once

#include "common/pair/stages/float/float_pair_kernel.hpp"

#include <cstddef>
#include <cstdint>

namespace cd {

/// What bounds the errors of a pair in floats, which near_pair_kernel.cpp derives.
struct NearPairErrors {
    // Weights of the error e of both bounds.
    float of_a = 0;      ///< Weight of the longer edge of A from its first corner.
    float of_b = 0;      ///< Weight of the longer edge of B from its first corner.
    float of_d = 0;      ///< Weight of the difference of the first corners.
    float of_corner = 0; ///< Weight of the error of B's posed corner.
};

/// The distance that pairs are compared with.
struct NearPairLimit {
    float raised = 0;  ///< At least the distance.
    float lowered = 0; ///< At most the distance.
};

/// The verdicts of the kernel, as bytes.
namespace near_verdict {
inline constexpr std::uint8_t unknown = 0;
inline constexpr std::uint8_t far = 1;
inline constexpr std::uint8_t near = 2;
} // namespace near_verdict

/// Pairs as `classify_in_floats` reads them.
struct NearPairBatch {
    const FloatPairPose& pose;
    const NearPairErrors& errors;
    const FloatPairBody& a;
    const FloatPairBody& b;
    const std::uint32_t* candidates; ///< A triangle number of A and one of B for each pair.
    std::size_t count = 0;
};

/// Writes a verdict for each pair: its distance, in A's coordinates, is above `limit.raised`, or
/// not above `limit.lowered`, or unknown.
void decide_near_in_floats(const NearPairBatch& batch,
                           const NearPairLimit& limit,
                           std::uint8_t* verdicts);

/// Writes bounds of each pair's distance in A's coordinates. Where nothing is proven they are 0 and
/// infinity.
void bound_distances_in_floats(const NearPairBatch& batch, float* lower, float* upper);

} // namespace cd
