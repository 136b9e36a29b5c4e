// Decides one pair per SIMD lane in doubles: the procedure of pair_decision.hpp for triangles with
// area. Compiled for every target.

// Highway's include guard: once per target.
#if defined(CD_DOUBLE_PAIRS_DECIDE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_DOUBLE_PAIRS_DECIDE_INL_HPP
#undef CD_DOUBLE_PAIRS_DECIDE_INL_HPP
#else
#define CD_DOUBLE_PAIRS_DECIDE_INL_HPP
#endif

#include "common/pair/pair_decision.hpp"
#include "common/pair/stages/double_batch/double_pairs_frame-inl.hpp"
#include "common/pair/stages/double_batch/double_pairs_signs-inl.hpp"
#include "common/pair/triangle_pair.hpp"

#include <hwy/highway.h>

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace double_pairs {

using pair_decision::next;

/// The lone corner of a triangle in each lane (LoneCorner of pair_decision.hpp): the first corner
/// where neither `is_second` nor `is_third` is set.
struct Lone {
    M is_second;
    M is_third;
    M is_above;
};

HWY_INLINE M is_exactly_one(M x, M y, M z) {
    return hn::AndNot(all_of(x, y, z), hn::Xor(hn::Xor(x, y), z));
}

HWY_INLINE Lone lone_corner(const Sides& s) {
    const M one_above = is_exactly_one(s.positive[0], s.positive[1], s.positive[2]);
    const M one_below = is_exactly_one(s.negative[0], s.negative[1], s.negative[2]);
    const auto is_lone = [&](std::size_t i) {
        const M otherwise =
            hn::Or(hn::And(one_below, s.negative[i]), hn::AndNot(one_below, s.zero[i]));
        return hn::Or(hn::And(one_above, s.positive[i]), hn::AndNot(one_above, otherwise));
    };
    // If neither side has exactly one corner, the lone corner lies in the plane. It counts as above
    // if another corner lies below.
    const M any_below = any_of(s.negative[0], s.negative[1], s.negative[2]);
    return {is_lone(1), is_lone(2), hn::Or(one_above, hn::AndNot(one_below, any_below))};
}

/// A value per corner, from the lone corner on, in the triangle's order or in reverse.
template <class T>
struct Arranged {
    T lone;
    T second;
    T third;
};

template <class T, class Choice>
HWY_INLINE Arranged<T>
arranged(T x0, T x1, T x2, Choice is_second, Choice is_third, Choice is_opposite) {
    const T after = hn::IfThenElse(is_second, x2, hn::IfThenElse(is_third, x0, x1));
    const T before = hn::IfThenElse(is_second, x0, hn::IfThenElse(is_third, x1, x2));
    return {hn::IfThenElse(is_second, x1, hn::IfThenElse(is_third, x2, x0)),
            hn::IfThenElse(is_opposite, before, after),
            hn::IfThenElse(is_opposite, after, before)};
}

/// A triangle's corners from the lone corner p on, named as in `decide_crossing`.
template <class C>
struct Turned {
    C p[3];
    C q[3];
    C r[3];

    HWY_INLINE Turned() {}
};

template <class C>
HWY_INLINE Turned<C> turned(const C (&of)[3][3], const Lone& lone, M is_opposite) {
    Turned<C> to;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto arrange = [&](V C::*member) {
            const auto all = arranged(of[0][k].*member,
                                      of[1][k].*member,
                                      of[2][k].*member,
                                      lone.is_second,
                                      lone.is_third,
                                      is_opposite);
            to.p[k].*member = all.lone;
            to.q[k].*member = all.second;
            to.r[k].*member = all.third;
        };
        arrange(&C::at);
        if constexpr (std::is_same_v<C, Component>) {
            arrange(&C::error);
        }
    }
    return to;
}

/// Coincident pairs of corners, one bit each, as CornerPairs of double_signs.hpp.
class OnePoints {
  public:
    using Ints = hn::RebindToSigned<Doubles>;
    using Bits = hn::Vec<Ints>;

    template <class C>
    HWY_INLINE explicit OnePoints(const Frame<C>& frame) : bits_(hn::Zero(Ints())) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                const Bits bit = hn::Set(Ints(), std::int64_t{1} << (3 * i + j));
                bits_ =
                    hn::Or(bits_, hn::IfThenElseZero(hn::RebindMask(Ints(), frame.one[i][j]), bit));
            }
        }
    }

    HWY_INLINE M any() const { return is_set(bits_); }
    /// Tests for any coincident pair except those in `without`.
    HWY_INLINE M any_but(Bits without) const { return is_set(hn::AndNot(without, bits_)); }

    /// Returns, for each corner of a triangle, the set of pairs with that corner, arranged.
    static HWY_INLINE Arranged<Bits>
    pairs_of(std::int64_t first, int step, const Lone& lone, M is_opposite) {
        const Ints d;
        return arranged(hn::Set(d, first),
                        hn::Set(d, first << step),
                        hn::Set(d, first << (2 * step)),
                        hn::RebindMask(d, lone.is_second),
                        hn::RebindMask(d, lone.is_third),
                        hn::RebindMask(d, is_opposite));
    }

  private:
    static HWY_INLINE M is_set(Bits bits) {
        return hn::RebindMask(Doubles(), hn::Not(hn::Eq(bits, hn::Zero(Ints()))));
    }

    Bits bits_;
};

HWY_INLINE V code(PairClass kind) {
    return hn::Set(Doubles(), static_cast<double>(kind));
}

/// Decides as `decide_crossing` of pair_decision.hpp. In addition, a shared corner proves Touch
/// unless the triangles may cross properly.
template <class C>
HWY_INLINE V
decide_crossing(const Frame<C>& frame, const Prover& prover, const Sides& of_a, const Sides& of_b) {
    const Lone lone_a = lone_corner(of_a);
    const Lone lone_b = lone_corner(of_b);
    const M turns_a = hn::Not(lone_b.is_above);
    const M turns_b = hn::Not(lone_a.is_above);
    const Turned<C> a = turned(frame.a, lone_a, turns_a);
    const Turned<C> b = turned(frame.b, lone_b, turns_b);
    const Turned<C> b_across = turned(frame.b_across, lone_b, turns_b);

    const OnePoints ones(frame);
    const auto rows = OnePoints::pairs_of(double_signs::all_with_a, 3, lone_a, turns_a);
    const auto columns = OnePoints::pairs_of(double_signs::all_with_b, 1, lone_b, turns_b);
    const SizedVec across = between(a.p, b_across.p);
    const Sign first = prover.volume_sign(dot(cross(between(a.p, a.q), across), between(b.p, b.q)),
                                          ones.any_but(hn::Or(rows.third, columns.third)));
    const Sign second = prover.volume_sign(dot(cross(between(a.p, a.r), across), between(b.p, b.r)),
                                           ones.any_but(hn::Or(rows.second, columns.second)));

    const M both_cross = hn::And(of_a.do_cross(), of_b.do_cross());
    const M is_proper = all_of(both_cross, first.negative, second.positive);
    const M is_joined =
        hn::And(hn::Or(first.negative, first.zero), hn::Or(second.positive, second.zero));
    const M touches = hn::Or(is_joined, hn::AndNot(both_cross, ones.any()));
    V verdict = hn::Set(Doubles(), undecided_pair);
    verdict = hn::IfThenElse(touches, code(PairClass::Touch), verdict);
    verdict = hn::IfThenElse(is_proper, code(PairClass::Proper), verdict);
    return hn::IfThenElse(
        hn::Or(first.positive, second.negative), code(PairClass::Separate), verdict);
}

/// Projects onto the two coordinates that follow an axis.
class View {
  public:
    /// Chooses the axis of the normal's longest component.
    HWY_INLINE explicit View(const SizedVec& normal) {
        const V x = hn::Abs(normal.x.value);
        const V y = hn::Abs(normal.y.value);
        const V z = hn::Abs(normal.z.value);
        is_x_ = hn::And(hn::Ge(x, y), hn::Ge(x, z));
        is_y_ = hn::Ge(y, z);
    }
    HWY_INLINE V along(V of_x, V of_y, V of_z) const {
        return hn::IfThenElse(is_x_, of_x, hn::IfThenElse(is_y_, of_y, of_z));
    }
    HWY_INLINE Sized along(const SizedVec& of) const {
        return {along(of.x.value, of.y.value, of.z.value), along(of.x.size, of.y.size, of.z.size)};
    }
    template <class C>
    HWY_INLINE C first(const C (&of)[3]) const {
        return along(of[1], of[2], of[0]);
    }
    template <class C>
    HWY_INLINE C second(const C (&of)[3]) const {
        return along(of[2], of[0], of[1]);
    }

  private:
    HWY_INLINE ExactComponent along(const ExactComponent& x,
                                    const ExactComponent& y,
                                    const ExactComponent& z) const {
        return ExactComponent(along(x.at, y.at, z.at));
    }
    HWY_INLINE Component along(const Component& x, const Component& y, const Component& z) const {
        return {along(x.at, y.at, z.at), along(x.error, y.error, z.error)};
    }

    M is_x_;
    M is_y_;
};

/// A projected difference.
struct Seen {
    Sized x;
    Sized y;

    HWY_INLINE Seen() {}
    HWY_INLINE Seen(const Sized& of_x, const Sized& of_y) : x(of_x), y(of_y) {}

    HWY_INLINE Seen opposite() const {
        return {{hn::Neg(x.value), x.size}, {hn::Neg(y.value), y.size}};
    }
};

/// Collects what is proven for the edges added so far: see `decide_coplanar` of pair_decision.hpp.
struct EdgesSeen {
    M any_parts;   ///< The other triangle is strictly outside some edge.
    M all_overlap; ///< Inside each edge lies a corner of the other triangle.
    M any_shuts;   ///< No corner of the other triangle is inside some edge.
    M any_open;    ///< Whether a corner is inside is unproven for some edge.

    HWY_INLINE EdgesSeen() {
        const Doubles d;
        any_parts = any_shuts = any_open = hn::Lt(hn::Zero(d), hn::Zero(d));
        all_overlap = hn::Eq(hn::Zero(d), hn::Zero(d));
    }
    /// Adds one edge by its turns to the other triangle's corners; positive means inside.
    HWY_INLINE void add(const Sign& x, const Sign& y, const Sign& z) {
        const M inside = any_of(x.positive, y.positive, z.positive);
        const M known = all_of(is_known(x), is_known(y), is_known(z));
        any_parts = hn::Or(any_parts, all_of(x.negative, y.negative, z.negative));
        all_overlap = hn::And(all_overlap, inside);
        any_shuts = hn::Or(any_shuts, hn::AndNot(inside, known));
        any_open = hn::Or(any_open, hn::Not(hn::Or(inside, known)));
    }
};

/// Finds the turns from the edges of coplanar triangles to the other triangle's corners, as seen by
/// a View.
template <class C>
class FlatPairs {
  public:
    HWY_INLINE FlatPairs(const Frame<C>& frame, const Prover& prover, const View& view)
        : frame_(frame), prover_(prover), view_(view) {
        for (std::size_t i = 0; i < 3; ++i) {
            const C x = view.first(frame.a[i]);
            const C y = view.second(frame.a[i]);
            for (std::size_t j = 0; j < 3; ++j) {
                across_[i][j] = {between(x, view.first(frame.b_across[j])),
                                 between(y, view.second(frame.b_across[j]))};
            }
        }
    }

    /// Adds A's edges against B; A's turns have the sign of `own`.
    HWY_INLINE void look_from_a(V own, EdgesSeen& seen) const {
        for (std::size_t i = 0; i < 3; ++i) {
            const Seen edge = seen_edge(frame_.a[i], frame_.a[next(i)]);
            Sign turns[3];
            for (std::size_t k = 0; k < 3; ++k) {
                turns[k] = turn(edge, across_[i][k], own, one(i, k, next(i), k));
            }
            seen.add(turns[0], turns[1], turns[2]);
        }
    }
    HWY_INLINE void look_from_b(V own, EdgesSeen& seen) const {
        for (std::size_t i = 0; i < 3; ++i) {
            const Seen edge = seen_edge(frame_.b[i], frame_.b[next(i)]);
            Sign turns[3];
            for (std::size_t k = 0; k < 3; ++k) {
                turns[k] = turn(edge, across_[k][i].opposite(), own, one(k, i, k, next(i)));
            }
            seen.add(turns[0], turns[1], turns[2]);
        }
    }

  private:
    HWY_INLINE Seen seen_edge(const C (&from)[3], const C (&to)[3]) const {
        return {between(view_.first(from), view_.first(to)),
                between(view_.second(from), view_.second(to))};
    }
    HWY_INLINE M one(std::size_t i, std::size_t j, std::size_t i_to, std::size_t j_to) const {
        return hn::Or(frame_.one[i][j], frame_.one[i_to][j_to]);
    }
    /// Returns the turn, positive on the side of `own`.
    HWY_INLINE Sign turn(const Seen& edge, const Seen& to, V own, M is_one) const {
        Sized area = determinant(edge.x, edge.y, to.x, to.y);
        area.value = hn::Xor(area.value, hn::And(own, hn::SignBit(Doubles())));
        return prover_.area_sign(area, is_one);
    }

    const Frame<C>& frame_;
    const Prover& prover_;
    const View& view_;
    Seen across_[3][3]; ///< Difference from corner i of A to corner j of B.
};

/// Decides as `decide_coplanar` of pair_decision.hpp, along the longest axis of A's normal. In
/// addition, a shared corner proves that triangles are not separate. Meaningless in lanes outside
/// `is_flat`.
template <class C>
HWY_INLINE V decide_flat(const Frame<C>& frame,
                         const Prover& prover,
                         M is_flat,
                         const SizedVec& normal_a,
                         const SizedVec& normal_b) {
    const View view(normal_a);
    const M none = hn::Lt(hn::Zero(Doubles()), hn::Zero(Doubles()));
    const Sized own_a = view.along(normal_a);
    const Sized own_b = view.along(normal_b);
    const Sign turn_a = prover.area_sign(own_a, none);
    const Sign turn_b = prover.area_sign(own_b, none);
    const M have_area =
        hn::And(hn::Or(turn_a.positive, turn_a.negative), hn::Or(turn_b.positive, turn_b.negative));
    const M share_corner = OnePoints(frame).any();
    const FlatPairs flat(frame, prover, view);
    EdgesSeen seen;
    flat.look_from_a(own_a.value, seen);
    // If the triangles share a corner, an edge of A decides, unless they overlap.
    const M is_settled = hn::Or(seen.any_parts, hn::And(seen.any_shuts, share_corner));
    if (!hn::AllFalse(Doubles(), hn::AndNot(is_settled, is_flat))) {
        flat.look_from_b(own_b.value, seen);
    }
    const M may_part = hn::AndNot(share_corner, seen.any_open);
    V verdict = hn::Set(Doubles(), undecided_pair);
    verdict = hn::IfThenElse(hn::AndNot(may_part, seen.any_shuts), code(PairClass::Touch), verdict);
    verdict = hn::IfThenElse(seen.all_overlap, code(PairClass::Coplanar), verdict);
    verdict = hn::IfThenElse(seen.any_parts, code(PairClass::Separate), verdict);
    return hn::IfThenElse(have_area, verdict, hn::Set(Doubles(), undecided_pair));
}

/// Returns the class of each pair, or `undecided_pair`.
template <class C>
HWY_INLINE V decide(const Frame<C>& frame, double bound_scale) {
    const Doubles d;
    const Prover prover(frame.is_tame, bound_scale);
    const SizedVec normal_a =
        cross(between(frame.a[0], frame.a[1]), between(frame.a[0], frame.a[2]));
    const SizedVec normal_b =
        cross(between(frame.b[0], frame.b[1]), between(frame.b[0], frame.b[2]));
    Sides of_a;
    Sides of_b;
    for (std::size_t i = 0; i < 3; ++i) {
        const SizedVec to_a = between(frame.b_across[0], frame.a[i]);
        const SizedVec to_b = between(frame.a[0], frame.b_across[i]);
        const auto& one = frame.one;
        of_a.set(i,
                 prover.volume_sign(dot(normal_b, to_a), any_of(one[i][0], one[i][1], one[i][2])));
        of_b.set(i,
                 prover.volume_sign(dot(normal_a, to_b), any_of(one[0][i], one[1][i], one[2][i])));
    }
    const M separate = hn::Or(of_a.are_one_sided(), of_b.are_one_sided());
    const M flat_a = of_a.are_flat();
    const M flat_b = of_b.are_flat();
    const M is_crossing =
        hn::AndNot(any_of(separate, flat_a, flat_b), hn::And(of_a.are_known(), of_b.are_known()));
    const M is_flat = hn::And(flat_a, flat_b);
    V verdict = hn::IfThenElse(separate, code(PairClass::Separate), hn::Set(d, undecided_pair));
    if (!hn::AllFalse(d, is_crossing)) {
        verdict = hn::IfThenElse(is_crossing, decide_crossing(frame, prover, of_a, of_b), verdict);
    }
    if (!hn::AllFalse(d, is_flat)) {
        verdict = hn::IfThenElse(
            is_flat, decide_flat(frame, prover, is_flat, normal_a, normal_b), verdict);
    }
    return verdict;
}

} // namespace double_pairs
} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
