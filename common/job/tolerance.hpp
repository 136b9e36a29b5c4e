// The effects of a tolerance on a whole job: valid values, and the depth at which trees are cut.
#pragma once

#include "common/core/result.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>

namespace cd {

/// Checks a tolerance. Errors: BadInput unless it is a finite number of at least 0.
[[nodiscard]] Status check_tolerance(double tolerance);

/// Returns the distribution depth at which a tree is cut under a tolerance: the smallest at which a
/// distribution root would hold at most 1,024 triangles if the tree were balanced.
///
/// The boxes left undecided depend on where the trees are cut, because the descent starts anew at
/// each pair of distribution roots. Therefore, under a tolerance, the depth depends on the tree
/// alone and every program cuts at that depth, also the run in one process. The depth is small, so
/// that a coarse query can stop early.
[[nodiscard]] std::uint32_t tolerance_depth(const ObbTree& tree);

} // namespace cd
