// The error bounds are those derived in double_double_local.hpp and double_double_places.cpp: each
// value comes from the same operations in the same order, except that
// - an edge may start at its other corner, to which the bound of a place on an edge is indifferent
//   (it uses only the sum of both weights' magnitudes, and the edge's length);
// - a component that is known exactly replaces the computed one. It errs by 0, and by construction
//   so does the same component of a place between two corners that agree in it: the difference of
//   the corners is 0, and so is its product with the share;
// - Ziv's test is left out for such a component, whose high part is the rounded number.
// So lanes that prove an answer hold the correctly rounded numbers. As all operations but exact
// products are the same on every target, targets differ in which lanes do only where a part of such
// a product overflows or underflows.
#include "common/pair/points/crossing/crossing_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/pair/points/crossing/crossing_kernel.cpp"
#include <hwy/foreach_target.h>
// The header below is compiled for every target.
#include "common/pair/points/crossing/crossing_triangles-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace crossing {

/// The component of a place on the axis along which the ends of intervals are ordered.
constexpr std::size_t along = 3;

/// A point of an edge in the other triangle's plane, with its component `along`.
struct Place {
    Number at[4];
    M known[4]; ///< Unset if no row is plain.
    V error;    ///< Bounds the error of each component that is not known.

    HWY_INLINE Place() {}
};

template <bool has_plain>
HWY_INLINE Place choose(M which, const Place& yes, const Place& no) {
    Place place;
    for (std::size_t k = 0; k < 4; ++k) {
        place.at[k] = choose(which, yes.at[k], no.at[k]);
        if constexpr (has_plain) {
            place.known[k] = choose(which, yes.known[k], no.known[k]);
        }
    }
    place.error = choose(which, yes.error, no.error);
    return place;
}

/// Lanes in which the first of two numbers is provably less, greater or equal.
struct Order {
    M is_less;
    M is_greater;
    M is_equal;

    HWY_INLINE Order(M less, M greater, M equal)
        : is_less(less), is_greater(greater), is_equal(equal) {}
};

template <bool has_plain>
HWY_INLINE Order compare(const Place& x, const Place& y, std::size_t k) {
    const V difference = (x.at[k] - y.at[k]).high;
    const V error = hn::Mul(set(1.1), hn::Add(x.error, y.error));
    const M less = hn::Lt(difference, hn::Neg(error));
    const M greater = hn::Gt(difference, error);
    if constexpr (!has_plain) {
        return {less, greater, hn::Not(always())};
    } else {
        const M known = hn::And(x.known[k], y.known[k]);
        const Number& l = x.at[k];
        const Number& r = y.at[k];
        const M same = hn::Eq(l.high, r.high);
        return {choose(known,
                       hn::Or(hn::Lt(l.high, r.high), hn::And(same, hn::Lt(l.low, r.low))),
                       less),
                choose(known,
                       hn::Or(hn::Gt(l.high, r.high), hn::And(same, hn::Gt(l.low, r.low))),
                       greater),
                hn::And(known, is_equal(l, r))};
    }
}

/// Compares lexicographically; never proves equality.
template <bool has_plain>
HWY_INLINE Order compare(const Place& x, const Place& y) {
    Order order = compare<has_plain>(x, y, 0);
    if constexpr (has_plain) {
        for (std::size_t k = 1; k < 3; ++k) {
            const Order next = compare<has_plain>(x, y, k);
            order.is_less = hn::Or(order.is_less, hn::And(order.is_equal, next.is_less));
            order.is_greater = hn::Or(order.is_greater, hn::And(order.is_equal, next.is_greater));
            order.is_equal = hn::And(order.is_equal, next.is_equal);
        }
    }
    return order;
}

/// Lanes in which an axis is that of a vector's longest component.
struct MainAxis {
    M is_second;
    M is_third;

    HWY_INLINE MainAxis(V x, V y, V z)
        : is_second(hn::Gt(hn::Abs(y), hn::Abs(x))),
          is_third(hn::Gt(hn::Abs(z), hn::Max(hn::Abs(x), hn::Abs(y)))) {}

    template <class T>
    HWY_INLINE T of(const T (&components)[4]) const {
        return choose(is_third, components[2], choose(is_second, components[1], components[0]));
    }
};

/// Returns an axis along which the line of both planes runs: the order of two different components
/// there is the order of two points along the line.
HWY_INLINE MainAxis axis_of_line(const Vector& m, const Vector& n) {
    const auto component = [&](std::size_t i, std::size_t j) {
        return hn::Sub(hn::Mul(m.at[i].high, n.at[j].high), hn::Mul(m.at[j].high, n.at[i].high));
    };
    return {component(1, 2), component(2, 0), component(0, 1)};
}

/// An end of an edge: a corner, its side, and which of its components are known.
struct End {
    Vector corner;
    M known[3];
    Number side;

    HWY_INLINE End() {}
};

/// Chooses an end by `choice(first, second, third)` of three corners' values.
template <bool has_plain, class Choice>
HWY_INLINE End end_of(const Posed& own, const Cut& cut, const Choice& choice) {
    End end;
    for (std::size_t k = 0; k < 3; ++k) {
        end.corner.at[k] = choice(own.corners[0].at[k], own.corners[1].at[k], own.corners[2].at[k]);
        if constexpr (has_plain) {
            end.known[k] = choice(own.known[0][k], own.known[1][k], own.known[2][k]);
        }
    }
    end.side = choice(cut.sides[0], cut.sides[1], cut.sides[2]);
    return end;
}

/// Returns where an edge passes through the other triangle's plane, as piercing_place does.
template <bool has_plain>
HWY_INLINE Place piercing(const End& from,
                          const End& to,
                          const Posed& other,
                          const Cut& cut,
                          const Bounds& bounds,
                          const MainAxis& axis) {
    const Number divisor = from.side - to.side;
    const Number share = from.side / divisor;
    Place place;
    place.error =
        hn::Add(hn::Mul(set(4), bounds.corner_error),
                hn::Mul(cut.length,
                        hn::Add(hn::Div(hn::Mul(set(1.2), cut.side_error), hn::Abs(divisor.high)),
                                set(8 * e * bounds.scale))));
    for (std::size_t k = 0; k < 3; ++k) {
        const Number& start = from.corner.at[k];
        place.at[k] = start + share * (to.corner.at[k] - start);
        if constexpr (has_plain) {
            place.known[k] =
                hn::And(hn::And(from.known[k], to.known[k]), is_equal(start, to.corner.at[k]));
            // All points of a triangle perpendicular to an axis have the same component on it.
            const Number& flat = other.corners[0].at[k];
            const M is_flat =
                hn::And(hn::And(hn::And(other.known[0][k], other.known[1][k]), other.known[2][k]),
                        hn::And(is_equal(flat, other.corners[1].at[k]),
                                is_equal(flat, other.corners[2].at[k])));
            place.at[k] = choose(is_flat, flat, place.at[k]);
            place.known[k] = hn::Or(place.known[k], is_flat);
        }
    }
    place.at[along] = axis.of(place.at);
    if constexpr (has_plain) {
        place.known[along] = axis.of(place.known);
    }
    return place;
}

struct Ends {
    Place first;
    Place second;

    HWY_INLINE Ends(const Place& its_first, const Place& its_second)
        : first(its_first), second(its_second) {}
};

/// Returns the ends of a triangle's part of the line of both planes, ordered along the line. Clears
/// `proven` where the order is unproven.
template <bool has_plain>
HWY_INLINE Ends ends_of(const Posed& own,
                        const Posed& other,
                        const Cut& cut,
                        const Bounds& bounds,
                        const MainAxis& axis,
                        M& proven) {
    const End lone = end_of<has_plain>(
        own, cut, [&](const auto& x, const auto& y, const auto& z) { return cut.lone(x, y, z); });
    const End one = end_of<has_plain>(
        own, cut, [&](const auto& x, const auto& y, const auto&) { return cut.one(x, y); });
    const End last = end_of<has_plain>(
        own, cut, [&](const auto& x, const auto&, const auto& z) { return cut.other(x, z); });
    const Place p = piercing<has_plain>(lone, one, other, cut, bounds, axis);
    const Place q = piercing<has_plain>(lone, last, other, cut, bounds, axis);
    const Order order = compare<has_plain>(p, q, along);
    proven = hn::And(proven, hn::Or(order.is_less, order.is_greater));
    return {choose<has_plain>(order.is_less, p, q), choose<has_plain>(order.is_less, q, p)};
}

/// Intersects two intervals of a line. Clears `proven` where a comparison is unproven, two ends
/// coincide, or the intervals are disjoint.
template <bool has_plain>
HWY_INLINE Ends common_part(const Ends& a, const Ends& b, M& proven) {
    const Order low = compare<has_plain>(a.first, b.first, along);
    const Order high = compare<has_plain>(a.second, b.second, along);
    const Ends common{choose<has_plain>(low.is_less, b.first, a.first),
                      choose<has_plain>(high.is_less, a.second, b.second)};
    const Order order = compare<has_plain>(common.first, common.second, along);
    proven = hn::And(
        hn::And(proven, order.is_less),
        hn::And(hn::Or(low.is_less, low.is_greater), hn::Or(high.is_less, high.is_greater)));
    return common;
}

template <bool has_plain>
HWY_INLINE void
put(const Place& place, double scale, std::size_t first, CrossingsOfMany::Vectors& to, M& proven) {
    for (std::size_t k = 0; k < 3; ++k) {
        M is_proven = always();
        V value = rounded(place.at[k], place.error, scale, is_proven);
        if constexpr (has_plain) {
            value = choose(place.known[k], place.at[k].high, value);
            is_proven = hn::Or(is_proven, place.known[k]);
        }
        hn::Store(value, Doubles(), to[k].data() + first);
        proven = hn::And(proven, is_proven);
    }
}

/// Computes the pairs of one vector, from number `first` on.
template <bool has_plain>
HWY_INLINE void find(const CrossingPose& pose_a,
                     const CrossingPose& pose_b,
                     double scale,
                     const CornersOfMany& corners,
                     std::size_t first,
                     CrossingsOfMany& found) {
    const Given given_a[3] = {
        load(corners.a, 0, first), load(corners.a, 1, first), load(corners.a, 2, first)};
    const Given given_b[3] = {
        load(corners.b, 0, first), load(corners.b, 1, first), load(corners.b, 2, first)};
    M proven = always();
    V origin[3];
    origin_at<has_plain>(pose_a, given_a[0], scale, origin, proven);
    Posed a;
    Posed b;
    place<has_plain>(pose_a, given_a, origin, a, proven);
    place<has_plain>(pose_b, given_b, origin, b, proven);
    proven = hn::And(proven, is_in_range(hn::Max(a.magnitude, b.magnitude)));
    const Bounds bounds(a, b, scale);
    const Cut cut_a = cut(a, b, bounds, proven);
    const Cut cut_b = cut(b, a, bounds, proven);
    const MainAxis axis = axis_of_line(a.normal, b.normal);
    const Ends on_a = ends_of<has_plain>(a, b, cut_a, bounds, axis, proven);
    const Ends on_b = ends_of<has_plain>(b, a, cut_b, bounds, axis, proven);
    const Ends common = common_part<has_plain>(on_a, on_b, proven);
    const Order order = compare<has_plain>(common.first, common.second);
    proven = hn::And(proven, hn::Or(order.is_less, order.is_greater));
    put<has_plain>(choose<has_plain>(order.is_less, common.first, common.second),
                   scale,
                   first,
                   found.ends[0],
                   proven);
    put<has_plain>(choose<has_plain>(order.is_less, common.second, common.first),
                   scale,
                   first,
                   found.ends[1],
                   proven);
    for (std::size_t k = 0; k < 3; ++k) {
        hn::Store(origin[k], Doubles(), found.origin[k].data() + first);
    }
    hn::Store(hn::IfThenElseZero(proven, set(1)), Doubles(), found.proven.data() + first);
}

} // namespace crossing

void find_all(const CrossingPose& a,
              const CrossingPose& b,
              double bound_scale,
              const CornersOfMany& corners,
              std::size_t count,
              CrossingsOfMany& found) {
    const bool has_plain = a.has_plain_row() || b.has_plain_row();
    for (std::size_t first = 0; first < count; first += crossing::lanes) {
        if (has_plain) {
            crossing::find<true>(a, b, bound_scale, corners, first, found);
        } else {
            crossing::find<false>(a, b, bound_scale, corners, first, found);
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(find_all);

void find_crossings(const CrossingPose& a,
                    const CrossingPose& b,
                    double bound_scale,
                    const CornersOfMany& corners,
                    std::size_t count,
                    CrossingsOfMany& found) {
    HWY_DYNAMIC_DISPATCH(find_all)(a, b, bound_scale, corners, count, found);
}

} // namespace cd

#endif
