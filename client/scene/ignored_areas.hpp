// Sets of pairs of triangles, as rectangles: a range of triangles of A by one of B.
#pragma once

#include "common/tree/ignored_range.hpp"

#include <vector>

namespace cd {

/// Ranges of pairs of triangles of two bodies. The ranges may overlap.
using IgnoredAreas = std::vector<IgnoredRange>;

/// Removes the pairs of `hole` from all ranges. Each range that has some of them is replaced by up
/// to four others, which do not overlap. Bodies are kept.
void subtract(IgnoredAreas& areas, const IgnoredRange& hole);

} // namespace cd
