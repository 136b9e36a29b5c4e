// What a tolerance means for a job as a whole: which values it may have, and where trees are cut.
#pragma once

#include "common/core/result.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>

namespace cd {

/// Errors: BadInput unless the tolerance is a finite number of at least 0.
[[nodiscard]] Status check_tolerance(double tolerance);

/// The distribution depth at which a tree is cut under a tolerance: the least at which a root would
/// hold some thousand triangles if the tree were even.
///
/// Which boxes are left undecided depends on where the trees are cut, since the descent begins anew
/// at each pair of distribution roots. So under a tolerance the cut is part of the question: it is
/// a function of the tree alone, and everyone who answers uses it, the run in one process too.
/// Shallow, so that a coarse answer need not go down far before it may stop.
[[nodiscard]] std::uint32_t tolerance_depth(const ObbTree& tree);

} // namespace cd
