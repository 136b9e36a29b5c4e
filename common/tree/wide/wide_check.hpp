// What is asked of a wide tree that comes from elsewhere.
#pragma once

#include "common/core/result.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <cstddef>

namespace cd {

/// Done when a descent of these arrays reads nothing but them, ends, and meets each of so many
/// triangles once. Also for a tree without nodes, which has no arrays at all. That the corners are
/// the mesh's and boxes contain them is not checked. Errors: Io.
[[nodiscard]] Status check_wide_tree(const WideView& wide, std::size_t triangles);

} // namespace cd
