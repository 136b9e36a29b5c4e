// Signs of the turns of triangles around lines. Compiled for every target.

// Highway's include guard: once per target.
#if defined(CD_BUNDLE_TURNS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_BUNDLE_TURNS_INL_HPP
#undef CD_BUNDLE_TURNS_INL_HPP
#else
#define CD_BUNDLE_TURNS_INL_HPP
#endif

#include "common/shots/bundle/bundle_lanes-inl.hpp"
#include "common/shots/bundle/bundle_triangles_kernel.hpp"

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace bundle {

using Doubles = hn::CappedTag<double, 8>;
using V = hn::Vec<Doubles>;

constexpr auto lanes = static_cast<std::uint32_t>(hn::MaxLanes(Doubles()));

/// Returns twice the area of the triangle of the origin and two points, positive if it turns left.
template <class Vec>
HWY_INLINE Vec turn(Vec from_x, Vec from_y, Vec to_x, Vec to_y) {
    return hn::Sub(hn::Mul(from_x, to_y), hn::Mul(from_y, to_x));
}

/// Each lane's triangle: its corners across the lines and the bound of its turns.
struct Target {
    HWY_INLINE Target() {}

    /// Selects one triangle for all lanes.
    HWY_INLINE Target(const BlockAcross& placed, std::size_t triangle)
        : error(hn::Set(Doubles(), placed.turn_error[triangle])) {
        for (std::size_t i = 0; i < 3; ++i) {
            x[i] = hn::Set(Doubles(), placed.corners[1][i][triangle]);
            y[i] = hn::Set(Doubles(), placed.corners[2][i][triangle]);
        }
    }

    V x[3];
    V y[3];
    V error;
};

/// The lanes of a vector whose lines doubles do not prove to miss a triangle, as bit masks.
struct Marks {
    std::uint32_t left;  ///< All corners turn left around the line.
    std::uint32_t right; ///< All turn right.
    std::uint32_t open;
};

/// Marks lines at the given coordinates, those of the bit mask `valid`.
HWY_INLINE Marks marks_of(const Target& target, V line_x, V line_y, std::uint32_t valid) {
    const Doubles d;
    V x[3];
    V y[3];
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = hn::Sub(target.x[i], line_x);
        y[i] = hn::Sub(target.y[i], line_y);
    }
    const V turns[3] = {
        turn(x[0], y[0], x[1], y[1]), turn(x[1], y[1], x[2], y[2]), turn(x[2], y[2], x[0], y[0])};
    const V least = hn::Min(hn::Min(turns[0], turns[1]), turns[2]);
    const V most = hn::Max(hn::Max(turns[0], turns[1]), turns[2]);
    const V minus_error = hn::Neg(target.error);
    const auto misses = hn::And(hn::Lt(least, minus_error), hn::Gt(most, target.error));
    const std::uint32_t kept = ~bits_of(d, misses) & valid;
    const std::uint32_t left = kept & bits_of(d, hn::Gt(least, target.error));
    const std::uint32_t right = kept & bits_of(d, hn::Lt(most, minus_error));
    return {left, right, kept & ~(left | right)};
}

} // namespace bundle
} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
