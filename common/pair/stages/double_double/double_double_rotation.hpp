// A pose's linear part in double-double.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/pair/numbers/double_double.hpp"

#include <array>

namespace cd {

using DoubleDoubleVec = std::array<DoubleDouble, 3>;
using DoubleDoubleMatrix = std::array<DoubleDoubleVec, 3>; ///< Row-major.

/// Returns the linear part: exactly for a matrix. For a quaternion each entry is at most 1 and errs
/// by at most 10 `double_double_error`.
[[nodiscard]] DoubleDoubleMatrix double_double_rotation(const Pose& pose);

} // namespace cd
