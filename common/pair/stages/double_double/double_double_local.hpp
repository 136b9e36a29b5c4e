// A posed triangle relative to a point near it, in pairs of doubles.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/stages/double_double/double_double_rotation.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace cd {

/// Magnitudes within which neither overflow nor underflow matters: products of four lengths stay
/// far below 2^996, and what underflow does, some 2^-1074, far below any bound in use.
inline constexpr double local_length_least = 0x1p-200;
inline constexpr double local_length_most = 0x1p200;

/// A body's pose, and bounds on it.
struct LocalMap {
    /// A row of the linear part that is known to have this one entry, exactly, and else only 0.
    struct PlainRow {
        Eigen::Index column = 0;
        double entry = 0;
    };

    DoubleDoubleMatrix rows;
    Vec3 translation;
    double largest = 0; ///< Bounds each |entry| of the rows.
    bool is_matrix = false;
    std::array<std::optional<PlainRow>, 3> plain;

    explicit LocalMap(const Pose& pose);

    /// Bounds the magnitudes of the terms of R x + offset.
    [[nodiscard]] double magnitude_of(const Vec3& x, const Vec3& offset) const;
    /// R x + t - origin, each component within `local_error` of the magnitude of its terms.
    [[nodiscard]] DoubleDoubleVec place(const Vec3& x, const Vec3& origin) const;
    /// Component k of R x + t, where it is surely the sum of two doubles. The high part is the
    /// nearest double, so that equal numbers are equal in both parts.
    [[nodiscard]] std::optional<DoubleDouble> exact_component(const Vec3& x, std::size_t k) const;
    /// Component k of R x + t - origin, rounded once, where it is two doubles in sum and the pose
    /// is a matrix: short numbers often lie in the middle between two doubles.
    [[nodiscard]] std::optional<double>
    nearest_component(const Vec3& x, const Vec3& origin, std::size_t k) const;
};

/// The nearest double of a sum, where the sum is exactly that of two doubles.
template <std::size_t n>
[[nodiscard]] std::optional<double> nearest_sum(std::array<double, n> terms) {
    // Each pass leaves the sum as it is (Ogita, Rump, Oishi, Accurate sum and dot product, 2005,
    // algorithm 4.3) and moves what fits to the end.
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

/// 10 e from the rotation, e from the products together and e from each of the three sums, with
/// room for terms of higher order and for the roundings of the bounds themselves.
[[nodiscard]] inline double local_error(double magnitude) {
    return 20 * double_double_error * magnitude;
}

/// A triangle relative to an origin, with what is computed from it alone.
struct LocalTriangle {
    /// Of a corner in the world, where it is known exactly. Edges and faces at right angles to an
    /// axis of an unrotated body share them.
    using ExactComponents = std::array<std::optional<DoubleDouble>, 3>;

    std::array<DoubleDoubleVec, 3> corners;
    std::array<ExactComponents, 3> world;
    DoubleDoubleVec normal;
    double magnitude = 0; ///< Bounds the terms that the coordinates were summed from.
    Vec3 least;           ///< Of the corners' high parts.
    Vec3 greatest;

    LocalTriangle(const LocalMap& map, const Corners& corners, const Vec3& origin);
};

[[nodiscard]] inline DoubleDoubleVec operator-(const DoubleDoubleVec& l, const DoubleDoubleVec& r) {
    return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}

[[nodiscard]] inline DoubleDouble dot(const DoubleDoubleVec& l, const DoubleDoubleVec& r) {
    return l[0] * r[0] + l[1] * r[1] + l[2] * r[2];
}

} // namespace cd
