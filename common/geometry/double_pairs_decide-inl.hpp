// What doubles prove of as many pairs as a vector of them has lanes: the signs of DoubleSigns, and
// the procedure of pair_decision.hpp for triangles with area. Compiled for every target.

// Highway's guard: once for each target.
#if defined(CD_DOUBLE_PAIRS_DECIDE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_DOUBLE_PAIRS_DECIDE_INL_HPP
#undef CD_DOUBLE_PAIRS_DECIDE_INL_HPP
#else
#define CD_DOUBLE_PAIRS_DECIDE_INL_HPP
#endif

#include "common/geometry/double_pairs_frame-inl.hpp"
#include "common/geometry/triangle_pair.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace double_pairs {

constexpr std::size_t next(std::size_t corner) {
    return (corner + 1) % 3;
}

HWY_INLINE M any_of(M x, M y, M z) {
    return hn::Or(hn::Or(x, y), z);
}

HWY_INLINE M all_of(M x, M y, M z) {
    return hn::And(hn::And(x, y), z);
}

struct SizedVec {
    Sized x;
    Sized y;
    Sized z;
};

HWY_INLINE SizedVec between(const Component (&from)[3], const Component (&to)[3]) {
    return {between(from[0], to[0]), between(from[1], to[1]), between(from[2], to[2])};
}

/// a d - b c.
HWY_INLINE Sized determinant(const Sized& a, const Sized& b, const Sized& c, const Sized& d) {
    return {hn::Sub(hn::Mul(a.value, d.value), hn::Mul(b.value, c.value)),
            hn::Add(hn::Mul(a.size, d.size), hn::Mul(b.size, c.size))};
}

/// With sizes raised against underflow.
HWY_INLINE Sized raised(const Sized& s) {
    return {s.value, hn::Add(s.size, hn::Set(Doubles(), double_signs::size_raise))};
}

HWY_INLINE SizedVec cross(const SizedVec& l, const SizedVec& r) {
    return {raised(determinant(l.y, l.z, r.y, r.z)),
            raised(determinant(l.z, l.x, r.z, r.x)),
            raised(determinant(l.x, l.y, r.x, r.y))};
}

HWY_INLINE V dot(V lx, V ly, V lz, V rx, V ry, V rz) {
    return hn::Add(hn::Add(hn::Mul(lx, rx), hn::Mul(ly, ry)), hn::Mul(lz, rz));
}

HWY_INLINE Sized dot(const SizedVec& l, const SizedVec& r) {
    return {dot(l.x.value, l.y.value, l.z.value, r.x.value, r.y.value, r.z.value),
            dot(l.x.size, l.y.size, l.z.size, r.x.size, r.y.size, r.z.size)};
}

/// Where a sign is proven, and to be what.
struct Sign {
    M positive;
    M negative;
    M zero;
};

HWY_INLINE M is_known(const Sign& s) {
    return any_of(s.positive, s.negative, s.zero);
}

/// Proves signs, as DoubleSigns.
class Prover {
  public:
    HWY_INLINE Prover(M is_tame, double bound_scale)
        : is_tame_(is_tame),
          volume_bound_(hn::Set(Doubles(), bound_scale * double_signs::volume_bound)),
          area_bound_(hn::Set(Doubles(), bound_scale * double_signs::area_bound)) {}

    /// `is_one` says where corners that are one point make it 0.
    HWY_INLINE Sign volume_sign(const Sized& volume, M is_one) const {
        const M is_least = hn::Lt(volume.size, hn::Set(Doubles(), double_signs::term_least));
        return sign(volume.value,
                    hn::Mul(volume_bound_, volume.size),
                    hn::Or(is_one, hn::And(is_tame_, is_least)));
    }
    HWY_INLINE Sign area_sign(const Sized& area, M is_one) const {
        const M is_nothing = hn::Eq(area.size, hn::Zero(Doubles()));
        return sign(area.value,
                    hn::Mul(area_bound_, area.size),
                    hn::Or(is_one, hn::And(is_tame_, is_nothing)));
    }

  private:
    static HWY_INLINE Sign sign(V value, V error, M is_zero) {
        const V bound = hn::Add(error, hn::Set(Doubles(), double_signs::underflow));
        const M positive = hn::Gt(value, bound);
        const M negative = hn::Lt(value, hn::Neg(bound));
        return {positive, negative, hn::AndNot(hn::Or(positive, negative), is_zero)};
    }

    M is_tame_;
    V volume_bound_;
    V area_bound_;
};

/// Of a triangle's corners against the other's plane.
struct Sides {
    M positive[3];
    M negative[3];
    M zero[3];

    HWY_INLINE void set(std::size_t corner, const Sign& sign) {
        positive[corner] = sign.positive;
        negative[corner] = sign.negative;
        zero[corner] = sign.zero;
    }
    HWY_INLINE M are_known() const {
        return all_of(is_known({positive[0], negative[0], zero[0]}),
                      is_known({positive[1], negative[1], zero[1]}),
                      is_known({positive[2], negative[2], zero[2]}));
    }
    HWY_INLINE M are_one_sided() const {
        return hn::Or(all_of(positive[0], positive[1], positive[2]),
                      all_of(negative[0], negative[1], negative[2]));
    }
    HWY_INLINE M are_flat() const { return all_of(zero[0], zero[1], zero[2]); }
    /// With both signs.
    HWY_INLINE M do_cross() const {
        return hn::And(any_of(positive[0], positive[1], positive[2]),
                       any_of(negative[0], negative[1], negative[2]));
    }
};

/// `lone_corner` of pair_decision.hpp, which is the first where it is none of these.
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
    // Neither one above nor one below: one is in the plane, and any other says where both are.
    const M any_below = any_of(s.negative[0], s.negative[1], s.negative[2]);
    return {is_lone(1), is_lone(2), hn::Or(one_above, hn::AndNot(one_below, any_below))};
}

/// Three things of corners in their triangle's order, or in the opposite one, from the lone one.
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

/// The corners p, q, r of Guigue and Devillers.
struct Turned {
    Component p[3];
    Component q[3];
    Component r[3];
};

HWY_INLINE Turned turned(const Components& of, const Lone& lone, M is_opposite) {
    Turned to;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto at = arranged(
            of[0][k].at, of[1][k].at, of[2][k].at, lone.is_second, lone.is_third, is_opposite);
        const auto error = arranged(of[0][k].error,
                                    of[1][k].error,
                                    of[2][k].error,
                                    lone.is_second,
                                    lone.is_third,
                                    is_opposite);
        to.p[k] = {at.lone, error.lone};
        to.q[k] = {at.second, error.second};
        to.r[k] = {at.third, error.third};
    }
    return to;
}

/// Pairs of corners that are one point, a bit each, as CornerPairs of double_signs.hpp.
class OnePoints {
  public:
    using Ints = hn::RebindToSigned<Doubles>;
    using Bits = hn::Vec<Ints>;

    HWY_INLINE OnePoints(const Frame& frame) : bits_(hn::Zero(Ints())) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                const Bits bit = hn::Set(Ints(), std::int64_t{1} << (3 * i + j));
                bits_ =
                    hn::Or(bits_, hn::IfThenElseZero(hn::RebindMask(Ints(), frame.one[i][j]), bit));
            }
        }
    }

    HWY_INLINE M any() const { return is_set(bits_); }
    /// But for those of the corners in `without`.
    HWY_INLINE M any_but(Bits without) const { return is_set(hn::AndNot(without, bits_)); }

    /// The pairs of each of a triangle's corners, arranged.
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

/// `decide_crossing` of pair_decision.hpp; besides, triangles that share a corner touch.
HWY_INLINE V decide_crossing(const Frame& frame,
                             const Prover& prover,
                             const Sides& of_a,
                             const Sides& of_b) {
    const Lone lone_a = lone_corner(of_a);
    const Lone lone_b = lone_corner(of_b);
    const M turns_a = hn::Not(lone_b.is_above);
    const M turns_b = hn::Not(lone_a.is_above);
    const Turned a = turned(frame.a, lone_a, turns_a);
    const Turned b = turned(frame.b, lone_b, turns_b);
    const Turned b_across = turned(frame.b_across, lone_b, turns_b);

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

/// The two coordinates that follow an axis.
struct View {
    M is_x;
    M is_y;

    /// The longest of a normal.
    HWY_INLINE explicit View(const SizedVec& normal) {
        const V x = hn::Abs(normal.x.value);
        const V y = hn::Abs(normal.y.value);
        const V z = hn::Abs(normal.z.value);
        is_x = hn::And(hn::Ge(x, y), hn::Ge(x, z));
        is_y = hn::Ge(y, z);
    }
    HWY_INLINE V along(V of_x, V of_y, V of_z) const {
        return hn::IfThenElse(is_x, of_x, hn::IfThenElse(is_y, of_y, of_z));
    }
    HWY_INLINE Sized along(const SizedVec& of) const {
        return {along(of.x.value, of.y.value, of.z.value), along(of.x.size, of.y.size, of.z.size)};
    }
    HWY_INLINE Component first(const Component (&of)[3]) const {
        return {along(of[1].at, of[2].at, of[0].at), along(of[1].error, of[2].error, of[0].error)};
    }
    HWY_INLINE Component second(const Component (&of)[3]) const {
        return {along(of[2].at, of[0].at, of[1].at), along(of[2].error, of[0].error, of[1].error)};
    }
};

/// A difference as it is seen.
struct Seen {
    Sized x;
    Sized y;

    HWY_INLINE Seen opposite() const {
        return {{hn::Neg(x.value), x.size}, {hn::Neg(y.value), y.size}};
    }
};

/// What the edges of both triangles say, one after the other: see `decide_coplanar`.
struct EdgesSeen {
    M any_parts;
    M all_overlap;
    M any_shuts; ///< All of the other triangle is outside, or on the edge's line.
    M any_open;

    HWY_INLINE EdgesSeen() {
        const Doubles d;
        any_parts = any_shuts = any_open = hn::Lt(hn::Zero(d), hn::Zero(d));
        all_overlap = hn::Eq(hn::Zero(d), hn::Zero(d));
    }
    /// The turns to the other's three corners, positive where that is inside.
    HWY_INLINE void add(const Sign& x, const Sign& y, const Sign& z) {
        const M inside = any_of(x.positive, y.positive, z.positive);
        const M known = all_of(is_known(x), is_known(y), is_known(z));
        any_parts = hn::Or(any_parts, all_of(x.negative, y.negative, z.negative));
        all_overlap = hn::And(all_overlap, inside);
        any_shuts = hn::Or(any_shuts, hn::AndNot(inside, known));
        any_open = hn::Or(any_open, hn::Not(hn::Or(inside, known)));
    }
};

class FlatPairs {
  public:
    HWY_INLINE FlatPairs(const Frame& frame, const Prover& prover, const View& view)
        : frame_(frame), prover_(prover) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Component x = view.first(frame.a[i]);
            const Component y = view.second(frame.a[i]);
            const Component x_next = view.first(frame.a[next(i)]);
            const Component y_next = view.second(frame.a[next(i)]);
            edges_a_[i] = {between(x, x_next), between(y, y_next)};
            const Component bx = view.first(frame.b[i]);
            const Component by = view.second(frame.b[i]);
            const Component bx_next = view.first(frame.b[next(i)]);
            const Component by_next = view.second(frame.b[next(i)]);
            edges_b_[i] = {between(bx, bx_next), between(by, by_next)};
            for (std::size_t j = 0; j < 3; ++j) {
                across_[i][j] = {between(x, view.first(frame.b_across[j])),
                                 between(y, view.second(frame.b_across[j]))};
            }
        }
    }

    /// The turns of both triangles have the signs of `own_a` and `own_b`.
    HWY_INLINE EdgesSeen look(V own_a, V own_b) const {
        EdgesSeen seen;
        for (std::size_t i = 0; i < 3; ++i) {
            Sign of_a[3];
            Sign of_b[3];
            for (std::size_t k = 0; k < 3; ++k) {
                of_a[k] = turn(edges_a_[i], across_[i][k], own_a, one(i, k, next(i), k));
                of_b[k] = turn(edges_b_[i], across_[k][i].opposite(), own_b, one(k, i, k, next(i)));
            }
            seen.add(of_a[0], of_a[1], of_a[2]);
            seen.add(of_b[0], of_b[1], of_b[2]);
        }
        return seen;
    }

  private:
    HWY_INLINE M one(std::size_t i, std::size_t j, std::size_t i_to, std::size_t j_to) const {
        return hn::Or(frame_.one[i][j], frame_.one[i_to][j_to]);
    }
    /// Positive on the same side as `own`.
    HWY_INLINE Sign turn(const Seen& edge, const Seen& to, V own, M is_one) const {
        Sized area = determinant(edge.x, edge.y, to.x, to.y);
        area.value = hn::Xor(area.value, hn::And(own, hn::SignBit(Doubles())));
        return prover_.area_sign(area, is_one);
    }

    const Frame& frame_;
    const Prover& prover_;
    Seen edges_a_[3];
    Seen edges_b_[3];
    Seen across_[3][3]; ///< From corner i of A to corner j of B.
};

/// `decide_coplanar` of pair_decision.hpp, along the axis on which A's normal is longest; besides,
/// triangles that share a corner are not apart.
HWY_INLINE V decide_flat(const Frame& frame,
                         const Prover& prover,
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
    const EdgesSeen seen = FlatPairs(frame, prover, view).look(own_a.value, own_b.value);
    const M may_part = hn::AndNot(OnePoints(frame).any(), seen.any_open);
    V verdict = hn::Set(Doubles(), undecided_pair);
    verdict = hn::IfThenElse(hn::AndNot(may_part, seen.any_shuts), code(PairClass::Touch), verdict);
    verdict = hn::IfThenElse(seen.all_overlap, code(PairClass::Coplanar), verdict);
    verdict = hn::IfThenElse(seen.any_parts, code(PairClass::Separate), verdict);
    return hn::IfThenElse(have_area, verdict, hn::Set(Doubles(), undecided_pair));
}

/// The class of each pair, or `undecided_pair`.
HWY_INLINE V decide(const Frame& frame, double bound_scale) {
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
        verdict = hn::IfThenElse(is_flat, decide_flat(frame, prover, normal_a, normal_b), verdict);
    }
    return verdict;
}

} // namespace double_pairs
} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
