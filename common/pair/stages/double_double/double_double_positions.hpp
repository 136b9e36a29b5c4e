// Positions on two posed triangles, in double-double with error bounds: their order and rounding.
#pragma once

#include "common/pair/pair_decision.hpp"
#include "common/pair/stages/double_double/double_double_local.hpp"

#include <cstddef>
#include <optional>

namespace cd {

/// Bounds for a pair of triangles, for every component, computed or true.
struct LocalBounds {
    double corner_error = 0; ///< Bounds the error of each corner's component.
    double across = 0;       ///< Bounds the difference of any two of the six corners.
    double scale = 1;        ///< Multiplies all error bounds; less than 1 proves nothing.

    LocalBounds() = default;
    LocalBounds(const LocalTriangle& a, const LocalTriangle& b, double scale);
};

/// One triangle of a pair, and the sides of its corners against the other triangle's plane.
struct LocalHalf {
    const LocalTriangle* own = nullptr;
    const LocalTriangle* other = nullptr;
    double length = 0;     ///< Bounds the components of the triangle's edges.
    double side_error = 0; ///< Bounds the error of each of `sides`.
    DoubleDoubleVec sides;
    PlaneSides proven = unknown_sides; ///< The signs of the sides; `unknown_sign` where unproven.

    LocalHalf() = default;
    LocalHalf(const LocalTriangle& own, const LocalTriangle& other, const LocalBounds& bounds);
};

/// A corner, or a point on an edge at `share` of the way between two corners.
struct LocalPosition {
    const DoubleDoubleVec* from = nullptr;
    const DoubleDoubleVec* to = nullptr;  ///< Null for a corner.
    DoubleDouble share;                   ///< 0 at `from`, 1 at `to`; unused for a corner.
    double error = 0;                     ///< Bounds the error of each component.
    LocalTriangle::ExactComponents world; ///< The world components that are known exactly.

    [[nodiscard]] DoubleDouble component(std::size_t k) const {
        return to == nullptr ? (*from)[k] : (*from)[k] + share * ((*to)[k] - (*from)[k]);
    }
};

[[nodiscard]] LocalPosition
corner_position(const LocalTriangle& of, std::size_t corner, const LocalBounds& bounds);
/// Returns the point where an edge properly passes through the other triangle's plane.
[[nodiscard]] LocalPosition
piercing_position(const LocalHalf& of, std::size_t edge, const LocalBounds& bounds);
/// Returns the point where an edge of A properly crosses one of B in their common plane.
[[nodiscard]] LocalPosition crossing_position(const LocalHalf& a,
                                              std::size_t edge,
                                              const LocalHalf& b,
                                              std::size_t other,
                                              const LocalBounds& bounds);

/// Compares component k: returns -1 if x < y, 1 if x > y, 0 if equal; nothing if that is unproven.
[[nodiscard]] std::optional<int>
compare(const LocalPosition& x, const LocalPosition& y, std::size_t k);
/// Compares lexicographically; nothing if the order is unproven or the positions are equal.
[[nodiscard]] std::optional<int> compare(const LocalPosition& x, const LocalPosition& y);

/// Returns 1 if a, b, c turn left around a triangle's normal in its plane, -1 if right; nothing if
/// unproven.
[[nodiscard]] std::optional<int> turn(const LocalPosition& a,
                                      const LocalPosition& b,
                                      const LocalPosition& c,
                                      const LocalHalf& around,
                                      const LocalBounds& bounds);

/// Returns the axis of the vector's longest component, as far as doubles tell.
[[nodiscard]] std::size_t main_axis(const Vec3& vector);

/// Returns the double nearest to every number within `error` of `value`; nothing if these numbers
/// may round differently. If `error` is positive, the answer is not 0.
[[nodiscard]] std::optional<double>
rounded(const DoubleDouble& value, double error, const LocalBounds& bounds);
/// Rounds component k of a position relative to the origin; nothing if that is unproven.
[[nodiscard]] std::optional<double> rounded(const LocalPosition& position,
                                            std::size_t k,
                                            const Vec3& origin,
                                            const LocalBounds& bounds);

} // namespace cd
