// A posed triangle relative to a nearby origin, in double-double.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/stages/double_double/double_double_rotation.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace cd {

/// Bounds of lengths between which neither overflow nor underflow matters: products of four lengths
/// stay far below 2^996, and underflow's effect, some 2^-1074, far below any error bound in use.
inline constexpr double local_length_least = 0x1p-200;
inline constexpr double local_length_most = 0x1p200;

/// The least error of a side (`LocalHalf::side_error`) for which the bounds hold: far above the
/// effect of underflow.
inline constexpr double side_error_least = 0x1p-900;

/// A body's pose in double-double, with bounds.
struct LocalMap {
    /// A row of the linear part that is known exactly and has at most one nonzero entry.
    struct PlainRow {
        Eigen::Index column = 0;
        double entry = 0;
    };

    DoubleDoubleMatrix rows;
    Vec3 translation;
    double largest = 0; ///< Bounds each |entry| of the rows.
    bool is_matrix = false;
    std::array<std::optional<PlainRow>, 3> plain; ///< By row; empty for rows that are not plain.

    explicit LocalMap(const Pose& pose);

    /// Bounds the sum of the terms' magnitudes in each component of R x + offset.
    [[nodiscard]] double magnitude_of(const Vec3& x, const Vec3& offset) const;
    /// Computes R x + t - origin. Each component errs by at most `local_error(magnitude_of(x, t -
    /// origin))`.
    [[nodiscard]] DoubleDoubleVec place(const Vec3& x, const Vec3& origin) const;
    /// Returns component k of R x + t if it is provably the sum of two doubles. The high part is
    /// the nearest double, so equal numbers have equal parts.
    [[nodiscard]] std::optional<DoubleDouble> exact_component(const Vec3& x, std::size_t k) const;
    /// Returns component k of R x + t - origin, rounded once, if it is a sum of two doubles and the
    /// pose is a matrix; else nothing. Short numbers often lie midway between two doubles, where no
    /// error bound proves the rounding.
    [[nodiscard]] std::optional<double>
    nearest_component(const Vec3& x, const Vec3& origin, std::size_t k) const;
};

/// Returns the nearest double of a sum, if the sum is exactly that of two doubles; may return
/// nothing otherwise.
template <std::size_t n>
[[nodiscard]] std::optional<double> nearest_sum(std::array<double, n> terms) {
    // Each pass preserves the sum (Ogita, Rump, Oishi, Accurate sum and dot product, 2005,
    // algorithm 4.3) and moves its leading part to the end.
    for (int pass = 0; pass < 3; ++pass) {
        bool is_short = true;
        for (std::size_t i = 1; i < n; ++i) {
            const DoubleDouble sum = exact_sum(terms[i], terms[i - 1]);
            terms[i] = sum.high;
            terms[i - 1] = sum.low;
            is_short = is_short && (sum.low == 0 || i + 1 == n);
        }
        if (is_short) {
            return exact_sum(terms[n - 1], terms[n - 2]).high;
        }
    }
    return std::nullopt;
}

/// Bounds the error of a component whose terms have this sum of magnitudes: 10 e from the rotation,
/// e from all products and e from each of three sums (e is double_double_error), with room for
/// terms of higher order and the bounds' own roundings.
[[nodiscard]] inline double local_error(double magnitude) {
    return 20 * double_double_error * magnitude;
}

/// A triangle relative to an origin, with values derived from it alone.
struct LocalTriangle {
    /// The world coordinates of a corner that are known exactly. All corners of an edge or face
    /// perpendicular to an axis share their coordinate on that axis.
    using ExactComponents = std::array<std::optional<DoubleDouble>, 3>;

    std::array<DoubleDoubleVec, 3> corners;
    std::array<ExactComponents, 3> world;
    DoubleDoubleVec normal;
    double magnitude = 0; ///< The largest `LocalMap::magnitude_of` of a corner.
    Vec3 least;           ///< Least coordinate of the corners on each axis (high parts).
    Vec3 greatest;        ///< Greatest coordinate of the corners on each axis (high parts).

    LocalTriangle(const LocalMap& map, const Corners& corners, const Vec3& origin);
};

[[nodiscard]] inline DoubleDoubleVec operator-(const DoubleDoubleVec& l, const DoubleDoubleVec& r) {
    return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}

[[nodiscard]] inline DoubleDouble dot(const DoubleDoubleVec& l, const DoubleDoubleVec& r) {
    return l[0] * r[0] + l[1] * r[1] + l[2] * r[2];
}

} // namespace cd
