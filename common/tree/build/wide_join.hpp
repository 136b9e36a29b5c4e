// Joins the subtrees of a cut into a wide tree of the whole body.
#pragma once

#include "common/tree/cut.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <span>

namespace cd {

/// Makes a wide tree of the whole body from its upper tree and the wide subtrees of all its roots,
/// in order. A search of it gives the answers of all pairs of subtrees together, and need not begin
/// anew for each pair. The tree copies the subtrees' arrays, and has nodes of its own above the
/// roots: some milliseconds for a million triangles. It has no support points.
[[nodiscard]] WideTree join_subtrees(const TreeTop& top, std::span<const WideView> subtrees);

} // namespace cd
