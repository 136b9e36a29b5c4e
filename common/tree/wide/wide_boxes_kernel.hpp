// The SIMD code that bounds vertices by boxes, compiled once for every target. The code takes and
// returns plain values, and all targets give equal bits.
#pragma once

#include "common/geometry/triangle_blocks.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// A frame with an origin. Coordinate k of a point x is row_k . (x - center), rounded.
struct SeenFrame {
    std::array<double, 9> rows{};
    std::array<double, 3> center{};
};

/// The range of some vertices on the axes of a SeenFrame.
struct Spread {
    std::array<double, 3> low{};
    std::array<double, 3> high{};
    double reach = 0; ///< Largest sum of |x_k - center_k| of a vertex x, in the body's axes.
};

/// Coordinates of a block's vertices in a SeenFrame, by axis, padded to whole vectors.
struct BlockCoordinates {
    alignas(64) std::array<std::array<double, block_vertices_max + 16>, 3> along;
};

/// Computes the spread of vertices [begin, end) of these blocks; there is at least one. Stores the
/// vertices' coordinates unless `coordinates` is null; then the vertices are those of one block.
[[nodiscard]] Spread spread_of(const TriangleBlocks& blocks,
                               std::uint32_t begin,
                               std::uint32_t end,
                               const SeenFrame& frame,
                               BlockCoordinates* coordinates = nullptr);

/// Converts coordinates x on one axis to steps: (x - `origin` - `error`) / `step` for a low bound,
/// with + `error` for a high bound.
struct StepAxis {
    double origin = 0;
    double error = 0;
    double step = 0;
};

/// The spreads of a node's children, by axis, then by child, padded to whole vectors.
struct ChildSpreads {
    alignas(64) std::array<std::array<double, wide_children_max>, 3> low{};
    alignas(64) std::array<std::array<double, wide_children_max>, 3> high{};
};

/// Sets the boxes of `node.count` children, rounded outwards. All coordinates are within 255 steps.
void set_child_boxes(const ChildSpreads& spreads,
                     const std::array<StepAxis, 3>& axes,
                     WideNode& node);

/// Sets the boxes of a block's first `node.count` triangles, rounded outwards. All coordinates are
/// within 255 steps.
void set_triangle_boxes(const BlockCoordinates& coordinates,
                        std::size_t vertices,
                        const BlockCorners* corners,
                        const std::array<StepAxis, 3>& axes,
                        WideNode& node);

} // namespace cd
