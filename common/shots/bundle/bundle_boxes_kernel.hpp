// SIMD kernel of BundleSearch for boxes, compiled for every target; plain values in and out.
#pragma once

#include "common/shots/bundle/bundle_frame.hpp"
#include "common/shots/bundle/parallel_lines.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <array>
#include <cstdint>

namespace cd {

/// The lines across, as the boxes of children are compared with them: on each axis the least and
/// the greatest coordinate of each column or row, from the middle of the lines.
struct LinesAcross {
    struct Axis {
        float half = 0;       ///< Bounds all coordinates.
        float first_bin = 0;  ///< The place of the middle, counted in bins or in steps of a grid.
        float per_length = 0; ///< Bins or steps.
        float slack = 0;      ///< Bounds the error of a place, counted in bins or steps.
        std::int32_t last = 0;
        const float* least = nullptr;
        const float* most = nullptr;
    };
    std::array<Axis, 2> axes{};
    bool is_grid = false;
};

[[nodiscard]] LinesAcross lines_across(const ParallelLines& lines);

/// Boxes of a node's children across the lines, from the middle of the lines.
struct ChildrenAcross {
    using Floats = std::array<float, wide_children_max>;

    alignas(64) std::array<Floats, 2> low;
    alignas(64) std::array<Floats, 2> high;
};

/// Computes the boxes, outwards, and returns a bit mask of those that may hold a line: on each
/// axis, some line has a coordinate in the box. Bits of unused children are meaningless.
[[nodiscard]] std::uint32_t children_with_lines(const WideNode& node,
                                                const NodeAcross& across,
                                                const LinesAcross& lines,
                                                ChildrenAcross& boxes);

} // namespace cd
