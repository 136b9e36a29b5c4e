// Joins the subtrees of a cut into a wide tree of the whole body.
#pragma once

#include "common/tree/cut.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <span>

namespace cd {

/// Makes a wide tree of the whole body from its upper tree and the wide subtrees of all its roots,
/// in order of the roots. One search of this tree replaces the searches of all pairs of subtrees.
/// Copies the subtrees' arrays and adds nodes above the roots. The tree has no support points.
[[nodiscard]] WideTree join_subtrees(const TreeTop& top, std::span<const WideView> subtrees);

} // namespace cd
