// Points in floats.
#pragma once

#include "common/geometry/types.hpp"

#include <array>

namespace cd {

/// A point in floats.
using FloatPoint = std::array<float, 3>;

/// Returns the same point in doubles.
[[nodiscard]] inline Vec3 vector_of(const FloatPoint& point) {
    return {point[0], point[1], point[2]};
}

} // namespace cd
