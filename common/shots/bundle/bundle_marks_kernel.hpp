// SIMD kernel of BundleSearch for pairs, compiled for every target; plain values in and out.
#pragma once

#include "common/shots/bundle/bundle_triangles_kernel.hpp"
#include "common/shots/bundle/parallel_lines.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// Pairs of placed triangles and lines that doubles do not prove to be apart.
struct MarkedPairs {
    static constexpr std::size_t most = 256;
    using Lines = std::array<std::uint32_t, most>; ///< Numbers of lines.

    /// Lines that pass through the inside of a triangle.
    struct Run {
        std::uint32_t triangle; ///< Number of a placed triangle.
        std::uint32_t begin;    ///< Of the run's lines; they end where those of the next begin.
        bool turns_left;        ///< The triangle's corners do, seen along the axis.
    };

    std::uint64_t tested = 0; ///< All pairs looked at.
    std::uint32_t runs = 0;
    std::uint32_t passes = 0;
    std::uint32_t open = 0;
    std::array<Run, block_size> of_triangles;
    Lines passing;
    Lines open_lines; ///< Of pairs that are not decided.
    std::array<std::uint8_t, most> open_triangles;

    [[nodiscard]] std::uint32_t end_of(std::uint32_t run) const {
        return run + 1 < runs ? of_triangles[run + 1].begin : passes;
    }
};

/// A walk over the lines in the bins of placed triangles.
struct LineWalk {
    std::uint32_t triangle = 0; ///< The present triangle.
    std::uint32_t row = 0;      ///< Rows of its bins that are done.
    std::uint32_t line = 0;     ///< Lines of the present row that are done.
    bool are_few_done = false;  ///< Of a grid: triangles that have few lines are done.
};

/// Marks pairs until all are marked or there is no more room. Returns whether all are marked; if
/// not, another call goes on. No pair of a triangle that is not `between` passes.
[[nodiscard]] bool mark_pairs(const BlockAcross& placed,
                              const BundleAcross& bundle,
                              const LineRows& lines,
                              LineWalk& walk,
                              MarkedPairs& marked);

} // namespace cd
