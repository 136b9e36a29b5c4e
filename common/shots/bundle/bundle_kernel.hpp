// SIMD kernel of BundleSearch, compiled for every target; plain values in and out.
#pragma once

#include "common/geometry/triangle_blocks.hpp"
#include "common/shots/bundle/bundle_frame.hpp"
#include "common/shots/bundle/parallel_lines.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// The lines across, as the boxes of children are compared with them: on each axis the least and
/// the greatest coordinate of each column or row, from the middle of the lines.
struct LinesAcross {
    struct Axis {
        float half = 0;       ///< Bounds all coordinates.
        float first_bin = 0;  ///< The place of the middle, counted in bins.
        float per_length = 0; ///< Bins.
        float slack = 0;      ///< Bounds the error of a place, counted in bins.
        std::int32_t last = 0;
        const float* least = nullptr;
        const float* most = nullptr;
    };
    std::array<Axis, 2> axes{};
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

/// A block's vertices in the bundle's coordinates: along the lines, then across them. Numbers after
/// the last vertex are meaningless.
struct BlockAcross {
    static constexpr std::size_t most = block_vertices_max + 8;

    alignas(64) std::array<std::array<double, most>, 3> at;
};

void place_block(const TriangleBlocks& blocks,
                 std::uint32_t block,
                 const BundleFrame& frame,
                 BlockAcross& placed);

/// What doubles prove of a line and a triangle.
enum class LinePasses : std::uint8_t {
    Unknown = 0,
    Along = 1,   ///< Passes through the inside, and the corners turn left seen along the axis.
    Against = 2, ///< Passes through the inside, and the corners turn right.
};

/// A triangle, and the bins of the lines that may meet it.
struct TriangleAcross {
    std::array<std::array<double, 3>, 2> corners{}; ///< Across the lines, by axis.
    double error = 0;                               ///< Bounds the error of each turn.
    BinRange bins;                                  ///< Its first row moves on with the marks.
    std::uint32_t skipped = 0;                      ///< Lines of the first row that are done.
};

/// Lines that doubles do not prove to miss a triangle.
struct MarkedLines {
    static constexpr std::size_t most = 64;

    std::size_t count = 0;
    std::size_t tested = 0; ///< All lines of the call.
    std::array<std::uint32_t, most> lines;
    std::array<LinePasses, most> passes;
};

/// Marks lines of the triangle's bins until all are marked or there is no more room. Returns
/// whether all are marked; if not, another call goes on.
[[nodiscard]] bool mark_lines(TriangleAcross& triangle, const LineRows& lines, MarkedLines& marked);

} // namespace cd
