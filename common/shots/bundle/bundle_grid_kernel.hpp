// SIMD kernel of BundleSearch for grids of lines: decides pairs of triangles and lines.
#pragma once

#include "common/shots/bundle/bundle_marks_kernel.hpp"
#include "common/shots/bundle/bundle_triangles_kernel.hpp"
#include "common/shots/bundle/parallel_lines.hpp"

namespace cd {

/// Does what `mark_pairs` does, for the lines of a grid (`ParallelLines::is_grid`). Tests only
/// lines in the triangle's projected box, since the others cannot meet it.
[[nodiscard]] bool mark_grid_pairs(const BlockAcross& placed,
                                   const BundleAcross& bundle,
                                   const LineRows& lines,
                                   LineWalk& walk,
                                   MarkedPairs& marked);

} // namespace cd
