// SIMD kernel of BundleSearch for triangles, compiled for every target; plain values in and out.
#pragma once

#include "common/geometry/triangle_blocks.hpp"
#include "common/shots/bundle/bundle_frame.hpp"
#include "common/shots/bundle/parallel_lines.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// What the triangles of blocks are compared with.
struct BundleAcross {
    struct Axis {
        double least = 0;
        double bins_per_length = 0;
        double last_bin = 0;
        double bin_size = 0;
        const double* least_of_bins = nullptr; ///< LineSteps::least.
        const double* most_of_bins = nullptr;
        double steps_per_length = 0; ///< LineSteps::steps_per_length.
        double slack = 0;
    };
    /// The terms of the bound of a turn, for corners that are within S of a line, the sum of the
    /// bounds for both axes: `constant` + `linear` * S + `square` * S * S.
    struct TurnError {
        double constant = 0;
        double linear = 0;
        double square = 0;
    };
    std::array<Axis, 2> axes{};
    std::array<double, 2> ends{}; ///< Of the lines along their axis, the lesser first.
    double error = 0;             ///< Bounds the error of a vertex's coordinate.
    TurnError turn_error;
};

/// Returns the terms for corners that err by `error` in each coordinate, times `scale`.
[[nodiscard]] BundleAcross::TurnError turn_error_of(double error, double scale);

[[nodiscard]] BundleAcross
bundle_across(const ParallelLines& lines, double error, double bound_scale);

/// Triangles of a block in the bundle's coordinates.
struct BlockAcross {
    static constexpr std::size_t vertices_most = block_vertices_max + 8;
    using Doubles = std::array<double, block_size>;
    using Bins = std::array<std::int32_t, block_size>;

    alignas(64) std::array<std::array<double, vertices_most>, 3> vertices;
    alignas(64) std::array<std::array<Doubles, 3>, 3> corners; ///< By axis and corner.
    alignas(64) std::array<Doubles, 2> low;                    ///< Boxes across, outwards.
    alignas(64) std::array<Doubles, 2> high;
    alignas(64) std::array<Bins, 2> first; ///< Bins of the boxes.
    alignas(64) std::array<Bins, 2> last;
    alignas(64) Doubles turn_error;              ///< Bounds the error of each turn.
    std::array<std::uint8_t, block_size> places; ///< In the block.
    std::uint32_t count = 0;
    std::uint32_t between = 0; ///< Bit mask: strictly between the lines' ends.
};

/// Places those triangles of a block that a bit mask names.
void place_block(const TriangleBlocks& blocks,
                 std::uint32_t block,
                 std::uint32_t triangles,
                 const BundleFrame& frame,
                 const BundleAcross& bundle,
                 BlockAcross& placed);

} // namespace cd
