// Two poses in doubles, with error bounds.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/numbers/two_doubles.hpp"

#include <array>
#include <cstdint>

namespace cd {

/// Tame coordinates are 0 or within these magnitudes. Then sums with tame translations, and
/// differences, are multiples of 2^-203. In rotated bodies nonzero sizes are at least 2^-150 (the
/// least weight) times 2^-150, and at most 2^40.
inline constexpr double tame_least = 0x1p-150;
inline constexpr double tame_most = 0x1p33;

/// The poses of both bodies as doubles with error bounds, made from plain poses (see
/// `plain_poses`).
struct RoundedPoses {
    /// One row of a body's linear part.
    struct Row {
        int source = 0;            ///< Index of the body's coordinate that an exact row takes.
        double sign = 0;           ///< 1 or -1 for an exact row, else 0.
        std::uint32_t columns = 0; ///< Bit k is set if entry k may be nonzero.
    };
    struct Body {
        std::array<Row, 3> rows;
        Vec3 translation;
        std::uint32_t rounded_columns = 0; ///< Bits of all inexact rows' `columns`.
        bool is_none = false;              ///< True if the body is neither rotated nor moved.
    };

    /// True if all |translations| are 0 or tame, all |entries| at most 2, and all
    /// weights 0 or at least 2^-150.
    bool are_tame = true;
    bool are_rotated = false; ///< If false, all rows of both bodies are exact.
    std::array<Body, 2> bodies;

    // The members below are set only for rotated bodies. With m for a rounded entry and e for a
    // bound on its error, a component of R x errs by at most the sum of the weights 1.01 (e + 4.01
    // u |m|) times |x_k|, even where x_k is within u of itself. The product has that error, the
    // entry's, its own rounding and those of two sums. Weights and sizes of factors are raised
    // where their product could underflow.
    std::array<std::array<BothBodies, 3>, 3> entries;
    std::array<std::array<BothBodies, 3>, 3> weights;
    std::array<double, 3> offset{};       ///< ta - tb, rounded once.
    std::array<double, 3> offset_error{}; ///< 0 if `offset` is exact.

    explicit RoundedPoses(const PosePair& poses);
};

} // namespace cd
