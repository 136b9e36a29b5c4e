// Two poses in doubles, with what their use costs in exactness.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/numbers/two_doubles.hpp"

#include <array>
#include <cstdint>

namespace cd {

/// Of plain poses; see `plain_poses`.
struct RoundedPoses {
    /// One row of a body's linear part.
    struct Row {
        int source = 0;            ///< The coordinate that an exact row takes,
        double sign = 0;           ///< and 1 or -1; 0 for rows that are not exact.
        std::uint32_t columns = 0; ///< A bit for each entry that is not surely 0.
    };
    struct Body {
        std::array<Row, 3> rows;
        Vec3 translation;
        std::uint32_t rounded_columns = 0; ///< Those of all rows that are not exact.
        bool is_none = false;              ///< Neither rotated nor moved.
    };

    /// Whether translations are 0 or from 2^-150 to 2^33, entries at most 2, and weights 0 or at
    /// least 2^-150.
    bool are_tame = true;
    bool are_rotated = false; ///< Otherwise all rows of both are exact.
    std::array<Body, 2> bodies;

    // Only of rotated bodies. With m for a rounded entry and e for a bound on its error, a
    // component of R x errs by at most the sum of the weights 1.01 (e + 4.01 u |m|) times |x_k|,
    // even where x_k is within u of itself: its product is off by that, by the entry's error, by
    // its own rounding and by two of the sums. Where a product could underflow, weights and sizes
    // of factors are raised so that theirs cannot.
    std::array<std::array<BothBodies, 3>, 3> entries;
    std::array<std::array<BothBodies, 3>, 3> weights;
    std::array<double, 3> offset{};       ///< ta - tb, rounded once.
    std::array<double, 3> offset_error{}; ///< 0 where that is exact.

    explicit RoundedPoses(const PosePair& poses);
};

} // namespace cd
