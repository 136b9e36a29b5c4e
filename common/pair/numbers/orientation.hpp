// On which side of a line a point of the plane lies.
#pragma once

#include <array>

namespace cd {

using PlanePoint = std::array<double, 2>;

/// 1 when a, b, c turn to the left, -1 when they turn to the right, 0 on a line: exactly, for all
/// finite doubles. A filter in doubles decides first; the bound of its rounding error is that of
/// Shewchuk, Adaptive Precision Floating-Point Arithmetic (1997), section 4.3, made larger for
/// products that underflow.
[[nodiscard]] int orientation(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

} // namespace cd
