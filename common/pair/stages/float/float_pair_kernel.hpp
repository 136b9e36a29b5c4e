// SIMD kernel of FloatTrianglePair, compiled for every target; plain values in and out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// B's pose in A's coordinates, with error bounds, which float_pair_kernel.cpp derives.
struct FloatPairPose {
    std::array<float, 9> rotation{}; ///< Row-major; rotates the edges of B.
    /// Poses the first corner of B: the columns of the rotation and the translation, each padded
    /// with a zero and stored twice, as two rows of the longest vectors.
    alignas(64) std::array<std::array<double, 8>, 4> columns{};
    /// The posed corner errs by at most `point_error_reach` times its largest coordinate plus
    /// `point_error`.
    double point_error_reach = 0;
    double point_error = 0;

    // Weights of a triple product's rows in its error bound, relative to their sizes.
    float weight_a = 0;     ///< Weight of an edge of A.
    float weight_b = 0;     ///< Weight of an edge of B.
    float weight_d = 0;     ///< Weight of the difference of the first corners.
    float weight_error = 0; ///< Weight of the error of B's posed corner.

    bool is_usable = false; ///< If false, nothing can be proven.
};

/// Triangles of one body as the kernel reads them. `kind` decides which pointers are used.
struct FloatPairBody {
    enum class Kind {
        FloatBlocks,  ///< TriangleBlocks of floats.
        DoubleBlocks, ///< TriangleBlocks of doubles.
        Mesh,         ///< Three doubles per vertex, three vertex indices per triangle.
    };
    Kind kind = Kind::Mesh;
    const float* floats = nullptr;   ///< Vertices of FloatBlocks, three numbers each.
    const double* doubles = nullptr; ///< Vertices of the other kinds, three numbers each.
    const std::uint32_t* vertex_begin = nullptr; ///< First vertex of each block.
    const std::uint8_t* corners = nullptr;    ///< For blocks, four per triangle (see BlockCorners).
    const std::uint32_t* triangles = nullptr; ///< For a mesh, three vertex indices per triangle.
    double reach = 0; ///< Bounds every |coordinate| of blocks; 0 for a mesh.
};

/// Writes the FloatVerdicts of `count` pairs. `candidates` holds a triangle number of A and one of
/// B for each pair. Both bodies are blocks or both are meshes.
void classify_in_floats(const FloatPairPose& pose,
                        const FloatPairBody& a,
                        const FloatPairBody& b,
                        const std::uint32_t* candidates,
                        std::size_t count,
                        std::uint8_t* verdicts);

} // namespace cd
