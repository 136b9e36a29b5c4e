// Places on two posed triangles, in pairs of doubles with error bounds: their order and rounding.
#pragma once

#include "common/pair/pair_decision.hpp"
#include "common/pair/stages/double_double/double_double_local.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace cd {

/// Bounds for a pair, of single components, and of computed and of true values alike.
struct LocalBounds {
    double corner_error = 0;
    double across = 0; ///< Of the difference of any two of the six corners.
    double scale = 1;  ///< All error bounds are multiplied by this; less than 1 proves nothing.

    LocalBounds() = default;
    LocalBounds(const LocalTriangle& a, const LocalTriangle& b, double scale);
};

/// One triangle of a pair, and its corners against the other's plane.
struct LocalHalf {
    const LocalTriangle* own = nullptr;
    const LocalTriangle* other = nullptr;
    double length = 0;     ///< Bounds the components of its edges.
    double side_error = 0; ///< Of each of the sides.
    DoubleDoubleVec sides;
    PlaneSides proven = unknown_sides; ///< The signs of the sides.

    LocalHalf() = default;
    LocalHalf(const LocalTriangle& own, const LocalTriangle& other, const LocalBounds& bounds);
};

/// A corner, or a place on an edge at a share of the way from one corner to another.
struct LocalPlace {
    const DoubleDoubleVec* from = nullptr;
    const DoubleDoubleVec* to = nullptr; ///< Null for a corner.
    DoubleDouble share;
    double error = 0;                     ///< Of each component.
    LocalTriangle::ExactComponents world; ///< Its components in the world that are known exactly.

    [[nodiscard]] DoubleDouble component(std::size_t k) const {
        return to == nullptr ? (*from)[k] : (*from)[k] + share * ((*to)[k] - (*from)[k]);
    }
};

[[nodiscard]] LocalPlace
corner_place(const LocalTriangle& of, std::size_t corner, const LocalBounds& bounds);
/// Where an edge properly passes through the other triangle's plane.
[[nodiscard]] LocalPlace
piercing_place(const LocalHalf& of, std::size_t edge, const LocalBounds& bounds);
/// Where an edge of A properly crosses one of B in the plane of both.
[[nodiscard]] LocalPlace crossing_place(const LocalHalf& a,
                                        std::size_t edge,
                                        const LocalHalf& b,
                                        std::size_t other,
                                        const LocalBounds& bounds);

/// Whether x < y or y < x or x = y for sure, in component k: -1, 1, 0; else nothing.
[[nodiscard]] std::optional<int> compare(const LocalPlace& x, const LocalPlace& y, std::size_t k);
/// Lexicographically; nothing where that is open, and for places that are one.
[[nodiscard]] std::optional<int> compare(const LocalPlace& x, const LocalPlace& y);

/// Whether a, b, c turn to the left around a triangle's normal in its plane, or to the right: 1 or
/// -1; nothing where that is open.
[[nodiscard]] std::optional<int> turn(const LocalPlace& a,
                                      const LocalPlace& b,
                                      const LocalPlace& c,
                                      const LocalHalf& around,
                                      const LocalBounds& bounds);

/// The axis along which a vector is longest, as far as doubles tell.
[[nodiscard]] std::size_t main_axis(const Vec3& vector);

/// The nearest double of a number that is within `error` of `value`, if that is the same for all of
/// these. Where the answer is not 0 it is never -0.
[[nodiscard]] std::optional<double>
rounded(const DoubleDouble& value, double error, const LocalBounds& bounds);
/// Component k of a place relative to the origin, likewise.
[[nodiscard]] std::optional<double>
rounded(const LocalPlace& place, std::size_t k, const Vec3& origin, const LocalBounds& bounds);

} // namespace cd
