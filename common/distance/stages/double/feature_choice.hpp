// Chooses the feature of a pair that is probably the nearest, in doubles.
#pragma once

#include "common/geometry/types.hpp"

#include <array>
#include <cstddef>

namespace cd {

/// Returns the number of the feature (see `feature`) at which doubles find the triangles nearest.
/// `corners` are those of A, then of B. Promises nothing: a proof must check it.
[[nodiscard]] std::size_t likely_feature(const std::array<Vec3, 6>& corners);

} // namespace cd
