// SIMD kernel of BundleSearch for the pairs of triangles and lines of a grid, compiled for every
// target; plain values in and out.
#pragma once

#include "common/shots/bundle/bundle_marks_kernel.hpp"
#include "common/shots/bundle/bundle_triangles_kernel.hpp"
#include "common/shots/bundle/parallel_lines.hpp"

namespace cd {

/// Does what `mark_pairs` does, for the lines of a grid (`ParallelLines::is_grid`). Only lines in
/// a triangle's box across are looked at: the others are apart from it.
[[nodiscard]] bool mark_grid_pairs(const BlockAcross& placed,
                                   const BundleAcross& bundle,
                                   const LineRows& lines,
                                   LineWalk& walk,
                                   MarkedPairs& marked);

} // namespace cd
