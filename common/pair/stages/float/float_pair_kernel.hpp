// The SIMD code of FloatTrianglePair, compiled once for every target: plain values in and out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// B's pose in A's coordinates, with what its use costs in exactness; float_pair_kernel.cpp derives
/// the bounds.
struct FloatPairPose {
    std::array<float, 9> rotation{}; ///< By rows: what turns the edges of B.
    /// What poses the first corner of B: the columns of the rotation and the translation, each with
    /// a zero at its end, and twice, as two rows of the longest vectors.
    alignas(64) std::array<std::array<double, 8>, 4> columns{};
    /// The corner, posed, is within `point_error_reach` times its largest coordinate, and
    /// `point_error` more.
    double point_error_reach = 0;
    double point_error = 0;

    // What the bound of a triple product takes for each of its rows, by its size.
    float weight_a = 0;     ///< For edges of A,
    float weight_b = 0;     ///< for edges of B,
    float weight_d = 0;     ///< and for the difference of the corners,
    float weight_error = 0; ///< with this for the error of the posed one.

    bool is_usable = false; ///< Otherwise nothing can be proven.
};

/// Triangles of one body, as the kernel reads them: three numbers a vertex.
struct FloatPairBody {
    enum class Kind {
        FloatBlocks,  ///< TriangleBlocks of floats,
        DoubleBlocks, ///< or of doubles;
        Mesh,         ///< three doubles a vertex, three places a triangle.
    };
    Kind kind = Kind::Mesh;
    const float* floats = nullptr;
    const double* doubles = nullptr;
    const std::uint32_t* vertex_begin = nullptr;
    const std::uint8_t* corners = nullptr; ///< Four a triangle.
    const std::uint32_t* triangles = nullptr;
    double reach = 0; ///< No coordinate of blocks is larger.
};

/// `candidates` are places of triangles, A's and B's in turn. Both bodies are blocks or both are
/// meshes. Writes `count` FloatVerdicts.
void classify_in_floats(const FloatPairPose& pose,
                        const FloatPairBody& a,
                        const FloatPairBody& b,
                        const std::uint32_t* candidates,
                        std::size_t count,
                        std::uint8_t* verdicts);

} // namespace cd
