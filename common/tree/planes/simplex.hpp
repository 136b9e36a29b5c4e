// The point of a simplex that is nearest to the origin.
#pragma once

#include "common/geometry/types.hpp"

#include <array>
#include <cstddef>

namespace cd {

/// A convex combination of the corners of a simplex.
struct NearestOfSimplex {
    std::array<double, 4> weights{}; ///< Not negative; their sum is 1 within 2^-48.
    Vec3 point = Vec3::Zero();       ///< The combination.
    std::size_t corners = 0;         ///< Number of positive weights.
};

/// Returns the combination of `count` corners, 1 to 4, that is nearest to the origin, approximately
/// (Ericson, Real-Time Collision Detection, 2005, section 5.1). The weights are right in any case.
[[nodiscard]] NearestOfSimplex nearest_of_simplex(const std::array<Vec3, 4>& corners,
                                                  std::size_t count);

} // namespace cd
