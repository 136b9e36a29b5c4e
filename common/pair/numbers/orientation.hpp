// Orientation of three points in the plane.
#pragma once

#include <array>

namespace cd {

using PlanePoint = std::array<double, 2>;

/// Returns 1 if a, b, c turn left, -1 if right, 0 if collinear: exact for all finite doubles. A
/// filter in doubles decides first. Its error bound is that of Shewchuk, Adaptive Precision
/// Floating-Point Arithmetic (1997), section 4.3, enlarged for products that underflow.
[[nodiscard]] int orientation(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

} // namespace cd
