// The SIMD code of FloatTrianglePair, compiled once for every target: plain values in and out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// B's pose in A's coordinates, with what its use costs in exactness; float_pair_kernel.cpp derives
/// the bounds.
struct FloatPairPose {
    std::array<double, 9> rotation{}; ///< By rows.
    std::array<double, 3> translation{};
    /// The first corner of B, posed, is within `point_error_reach` times its largest coordinate,
    /// and `point_error` more, in each component.
    double point_error_reach = 0;
    double point_error = 0;

    // The weights of sizes and errors in the bounds; `Extent` in the kernel.
    float size_weight = 0;
    float error_weight = 0;
    float underflow = 0;

    bool is_usable = false; ///< Otherwise nothing can be proven.
};

/// Triangles of one body, as the kernel reads them: three doubles a vertex, three places a
/// triangle.
struct FloatPairBody {
    const double* vertices;
    const std::uint32_t* triangles;
};

/// `candidates` are places of triangles, A's and B's in turn. Writes `count` FloatVerdicts.
void classify_in_floats(const FloatPairPose& pose,
                        const FloatPairBody& a,
                        const FloatPairBody& b,
                        const std::uint32_t* candidates,
                        std::size_t count,
                        std::uint8_t* verdicts);

} // namespace cd
