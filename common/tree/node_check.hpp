// What is asked of boxes that come from elsewhere.
#pragma once

#include "common/tree/obb_tree.hpp"

namespace cd {

/// True when the box is one that the box test can take: axes orthonormal within `axes_error_max`, a
/// finite centre, half sizes that are normal floats or infinite. Any such box is tested
/// conservatively; that it contains its triangles cannot be told from it.
[[nodiscard]] bool is_valid_box(const ObbNode& node);

} // namespace cd
