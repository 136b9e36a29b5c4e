// The SIMD code that makes boxes of vertices, compiled once for every target: plain values in and
// out, the same bits from each.
#pragma once

#include "common/geometry/triangle_blocks.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// A frame seen from a point: coordinate k of x is row_k . (x - center), rounded.
struct SeenFrame {
    std::array<double, 9> rows{};
    std::array<double, 3> center{};
};

/// Where some vertices lie on the axes of a seen frame.
struct Spread {
    std::array<double, 3> low{};
    std::array<double, 3> high{};
    double reach = 0; ///< No vertex is farther from the centre, by the sum of coordinates' sizes.
};

/// Of vertices [begin, end) of these blocks; one at least.
[[nodiscard]] Spread spread_of(const TriangleBlocks& blocks,
                               std::uint32_t begin,
                               std::uint32_t end,
                               const SeenFrame& frame);

/// The coordinates of a block's vertices in a seen frame, by axis, with room for whole vectors.
struct BlockPlaces {
    alignas(64) std::array<std::array<double, block_vertices_max + 16>, 3> along;
};

/// The same of one block, whose vertices' places it keeps.
[[nodiscard]] Spread spread_of_block(const TriangleBlocks& blocks,
                                     std::uint32_t block,
                                     const SeenFrame& frame,
                                     BlockPlaces& places);

/// What makes steps of places on one axis: places - origin, less or more `error`, over `step`.
struct StepAxis {
    double origin = 0;
    double error = 0;
    double step = 0;
};

/// The spreads of a node's children, by axis, then by child, with room for whole vectors.
struct ChildPlaces {
    alignas(64) std::array<std::array<double, wide_children_max>, 3> low{};
    alignas(64) std::array<std::array<double, wide_children_max>, 3> high{};
};

/// Sets the boxes of `node.count` children, rounded outwards. All places are within 255 steps.
void set_child_boxes(const ChildPlaces& places,
                     const std::array<StepAxis, 3>& axes,
                     WideNode& node);

/// Sets the boxes of a block's first `node.count` triangles, rounded outwards. All places are
/// within 255 steps.
void set_triangle_boxes(const BlockPlaces& places,
                        std::size_t vertices,
                        const BlockCorners* corners,
                        const std::array<StepAxis, 3>& axes,
                        WideNode& node);

} // namespace cd
