// Proves in integers that a proposed feature is the nearest, which is cheaper than to try them all.
#pragma once

#include "common/distance/stages/exact/exact_features.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace cd {

/// Returns the squared distance of two triangles that share no point, if it is that of the proposed
/// feature; may return nothing otherwise. `corners` are those of A, then of B.
///
/// With x and y for the feature's points, and v = x - y, the feature is the nearest if no corner of
/// A is below x along v, and none of B is above y: the lemma of distance_certificate.hpp then holds
/// with equality.
[[nodiscard]] std::optional<ExactSquare> square_if_nearest(const std::array<ExactVec, 6>& corners,
                                                           std::size_t proposed);

} // namespace cd
