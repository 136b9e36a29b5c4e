// Poses triangles, one pair per SIMD lane, and computes their sides, by the operations and with the
// bounds of LocalTriangle, LocalBounds and LocalHalf. Compiled for every target.

// Highway's include guard: once per target.
#if defined(CD_CROSSING_TRIANGLES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_CROSSING_TRIANGLES_INL_HPP
#undef CD_CROSSING_TRIANGLES_INL_HPP
#else
#define CD_CROSSING_TRIANGLES_INL_HPP
#endif

#include "common/pair/numbers/double_double_lanes-inl.hpp"
#include "common/pair/points/crossing/crossing_kernel.hpp"
#include "common/pair/stages/double_double/double_double_local.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace crossing {

using namespace double_double_lanes;
using double_double_lanes::choose;

constexpr std::size_t lanes = hn::MaxLanes(Doubles());
static_assert(CornersOfMany::pairs % lanes == 0);

constexpr double e = double_double_error;

/// An unposed corner, by axis.
struct Given {
    V at[3];

    HWY_INLINE Given() {}
};

HWY_INLINE Given load(const CornersOfMany::Triangles& triangles,
                      std::size_t corner,
                      std::size_t first) {
    Given given;
    for (std::size_t k = 0; k < 3; ++k) {
        given.at[k] = hn::Load(Doubles(), triangles[corner][k].data() + first);
    }
    return given;
}

/// Bounds the sum of the terms' magnitudes in each component of R x + offset.
HWY_INLINE V magnitude_of(const CrossingPose& pose, const Given& x, const V (&offset)[3]) {
    const V sum = hn::Add(hn::Add(hn::Abs(x.at[0]), hn::Abs(x.at[1])), hn::Abs(x.at[2]));
    const V most = hn::Max(hn::Max(hn::Abs(offset[0]), hn::Abs(offset[1])), hn::Abs(offset[2]));
    return hn::Mul(set(1.01), hn::Add(hn::Mul(set(pose.largest), sum), most));
}

HWY_INLINE V local_error_of(V magnitude) {
    return hn::Mul(set(20 * e), magnitude);
}

HWY_INLINE M is_in_range(V length) {
    return hn::And(hn::Ge(length, set(local_length_least)), hn::Le(length, set(local_length_most)));
}

/// Component k of R x, as a sum of two numbers.
struct Turned {
    Number first;
    Number rest;

    HWY_INLINE Turned(const CrossingPose& pose, const Given& x, std::size_t k)
        : first(term(pose, x, k, 0)), rest(term(pose, x, k, 1) + term(pose, x, k, 2)) {}

  private:
    static HWY_INLINE Number term(const CrossingPose& pose,
                                  const Given& x,
                                  std::size_t k,
                                  std::size_t j) {
        return Number(set(pose.high[k][j]), set(pose.low[k][j])) * x.at[j];
    }
};

/// A number, and the lanes in which it is exactly what it stands for.
struct Known {
    Number value;
    M is_known;

    HWY_INLINE Known() {}
    HWY_INLINE Known(const Number& its_value, M where) : value(its_value), is_known(where) {}
};

/// Computes component k, whose row is plain, of R x + t as LocalMap::exact_component does.
HWY_INLINE Known exact_world(const CrossingPose& pose, const Given& x, std::size_t k) {
    const CrossingPose::Row& row = pose.rows[k];
    const V factor = x.at[row.column];
    const M is_zero = hn::Eq(hn::Mul(set(row.entry), factor), hn::Zero(Doubles()));
    const M is_nothing = row.entry == 0 ? always() : hn::Eq(factor, hn::Zero(Doubles()));
    const Number product = exact_product(set(row.entry), factor);
    const M is_one_double = hn::And(hn::Eq(product.low, hn::Zero(Doubles())),
                                    hn::Ge(hn::Abs(factor), set(local_length_least)));
    return {exact_sum(hn::IfThenZeroElse(is_zero, product.high), set(pose.translation[k])),
            hn::Or(is_nothing, is_one_double)};
}

/// Subtracts an origin. The difference is known where two doubles hold it. Then equal differences
/// have equal parts.
HWY_INLINE Known relative_to(V origin, const Known& world) {
    const Number high = exact_sum(world.value.high, hn::Neg(origin));
    const Number rest = exact_sum(high.low, world.value.low);
    return {exact_sum(high.high, rest.high),
            hn::And(world.is_known, hn::Eq(rest.low, hn::Zero(Doubles())))};
}

/// Returns the double nearest to every number within `error` of `value`, as `rounded` of
/// double_double_places.hpp does. Clears `proven` where these numbers may round differently.
HWY_INLINE V rounded(const Number& value, V error, double scale, M& proven) {
    const V margin =
        hn::Add(hn::Mul(set(1.01), error), hn::Mul(set(scale * 0x1p-104), hn::Abs(value.high)));
    const V least = hn::Add(value.high, hn::Sub(value.low, margin));
    const V greatest = hn::Add(value.high, hn::Add(value.low, margin));
    proven = hn::And(proven, hn::Eq(least, greatest));
    return least;
}

/// Stands for LocalTriangle. Its components that are known replace the computed ones, and err by 0.
struct Posed {
    Vector corners[3];
    M known[3][3]; ///< By corner and axis; unset if no row is plain.
    Vector normal;
    V magnitude;
    V least[3];
    V greatest[3];

    HWY_INLINE Posed() {}
};

/// Places one component of one corner.
template <bool has_plain>
HWY_INLINE void
place(const CrossingPose& pose, const Given& x, V origin, std::size_t i, std::size_t k, Posed& to) {
    const Turned turned(pose, x, k);
    Number& at = to.corners[i].at[k];
    at = exact_sum(set(pose.translation[k]), hn::Neg(origin)) + turned.first + turned.rest;
    if constexpr (has_plain) {
        to.known[i][k] = hn::Not(always());
        if (pose.rows[k].is_plain) {
            const Known exact = relative_to(origin, exact_world(pose, x, k));
            at = choose(exact.is_known, exact.value, at);
            to.known[i][k] = exact.is_known;
        }
    }
    to.least[k] = i == 0 ? at.high : hn::Min(to.least[k], at.high);
    to.greatest[k] = i == 0 ? at.high : hn::Max(to.greatest[k], at.high);
}

/// Places a triangle relative to an origin. Clears `proven` where it is out of range.
template <bool has_plain>
HWY_INLINE void
place(const CrossingPose& pose, const Given (&x)[3], const V (&origin)[3], Posed& to, M& proven) {
    V offset[3];
    for (std::size_t k = 0; k < 3; ++k) {
        offset[k] = hn::Sub(set(pose.translation[k]), origin[k]);
    }
    to.magnitude = hn::Zero(Doubles());
    for (std::size_t i = 0; i < 3; ++i) {
        const V magnitude = magnitude_of(pose, x[i], offset);
        proven = hn::And(proven, hn::Le(magnitude, set(local_length_most)));
        to.magnitude = hn::Max(to.magnitude, magnitude);
        for (std::size_t k = 0; k < 3; ++k) {
            place<has_plain>(pose, x[i], origin[k], i, k, to);
        }
    }
    to.normal = cross(to.corners[1] - to.corners[0], to.corners[2] - to.corners[0]);
}

/// Computes a corner in the world, rounded. Clears `proven` where the rounding is unproven.
template <bool has_plain>
HWY_INLINE void
origin_at(const CrossingPose& pose, const Given& x, double scale, V (&to)[3], M& proven) {
    V translation[3];
    for (std::size_t k = 0; k < 3; ++k) {
        translation[k] = set(pose.translation[k]);
    }
    const V magnitude = magnitude_of(pose, x, translation);
    const V error = hn::Mul(set(scale), local_error_of(magnitude));
    proven = hn::And(proven, is_in_range(magnitude));
    for (std::size_t k = 0; k < 3; ++k) {
        const Turned turned(pose, x, k);
        M is_proven = always();
        to[k] = rounded(Number(translation[k], hn::Zero(Doubles())) + turned.first + turned.rest,
                        error,
                        scale,
                        is_proven);
        if (has_plain && pose.rows[k].is_plain) {
            const Known exact = exact_world(pose, x, k);
            to[k] = choose(exact.is_known, exact.value.high, to[k]);
            is_proven = hn::Or(is_proven, exact.is_known);
        }
        proven = hn::And(proven, is_proven);
    }
}

HWY_INLINE V length_between(const V (&least)[3], const V (&greatest)[3], V corner_error) {
    V farthest = hn::Zero(Doubles());
    V longest = hn::Zero(Doubles());
    for (std::size_t k = 0; k < 3; ++k) {
        farthest = hn::Max(farthest, hn::Max(hn::Abs(least[k]), hn::Abs(greatest[k])));
        longest = hn::Max(longest, hn::Sub(greatest[k], least[k]));
    }
    return hn::Add(hn::Add(hn::Mul(set(1.01), longest), hn::Mul(set(4 * 0x1p-53), farthest)),
                   hn::Mul(set(4), corner_error));
}

/// Stands for LocalBounds.
struct Bounds {
    V corner_error;
    V across;
    double scale;

    HWY_INLINE Bounds(const Posed& a, const Posed& b, double bound_scale)
        : corner_error(
              hn::Mul(set(bound_scale), local_error_of(hn::Max(a.magnitude, b.magnitude)))),
          across(corner_error),
          scale(bound_scale) {
        V least[3];
        V greatest[3];
        for (std::size_t k = 0; k < 3; ++k) {
            least[k] = hn::Min(a.least[k], b.least[k]);
            greatest[k] = hn::Max(a.greatest[k], b.greatest[k]);
        }
        across = length_between(least, greatest, corner_error);
    }
};

/// The corners of a triangle that the other one's plane cuts: the lone corner on its side, and the
/// two others.
struct Cut {
    M is_second; ///< Lanes in which the lone corner is the second.
    M is_third;  ///< Lanes in which the lone corner is the third.
    Number sides[3];
    V side_error;
    V length;

    HWY_INLINE Cut() {}

    /// Returns the values of the lone corner and of the two others.
    template <class T>
    HWY_INLINE T lone(const T& first, const T& second, const T& third) const {
        return choose(is_second, second, choose(is_third, third, first));
    }
    template <class T>
    HWY_INLINE T one(const T& first, const T& second) const {
        return choose(is_second, first, second);
    }
    template <class T>
    HWY_INLINE T other(const T& first, const T& third) const {
        return choose(is_third, first, third);
    }
};

/// Computes sides as LocalHalf does. Clears `proven` unless corners provably lie on both sides of
/// the other triangle's plane, and none in it.
HWY_INLINE Cut cut(const Posed& own, const Posed& other, const Bounds& bounds, M& proven) {
    const V other_length = length_between(other.least, other.greatest, bounds.corner_error);
    Cut found;
    found.length = length_between(own.least, own.greatest, bounds.corner_error);
    found.side_error =
        hn::Mul(hn::Mul(hn::Mul(set(48), other_length), bounds.across),
                hn::Add(bounds.corner_error, hn::Mul(set(e * bounds.scale), other_length)));
    const V bound = hn::Mul(set(1.01), found.side_error);
    M above[3];
    for (std::size_t i = 0; i < 3; ++i) {
        found.sides[i] = dot(other.normal, own.corners[i] - other.corners[0]);
        above[i] = hn::Gt(found.sides[i].high, bound);
        proven = hn::And(proven, hn::Gt(hn::Abs(found.sides[i].high), bound));
    }
    proven = hn::And(proven, hn::Ge(found.side_error, set(side_error_least * bounds.scale)));
    const M first_to_second = hn::Xor(above[0], above[1]);
    const M second_to_third = hn::Xor(above[1], above[2]);
    proven = hn::And(proven, hn::Or(first_to_second, second_to_third));
    found.is_second = hn::And(first_to_second, second_to_third);
    found.is_third = hn::AndNot(first_to_second, second_to_third);
    return found;
}

} // namespace crossing
} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
