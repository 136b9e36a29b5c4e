// Checks wide trees that come from outside.
#pragma once

#include "common/core/result.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <cstddef>

namespace cd {

/// Succeeds when a descent of these arrays stays within them, ends, and meets each of `triangles`
/// triangles once. Accepts a tree without nodes, which has no arrays at all. Does not check that
/// the corners are vertices of the mesh and that boxes contain their triangles. Errors: Io.
[[nodiscard]] Status check_wide_tree(const WideView& wide, std::size_t triangles);

} // namespace cd
