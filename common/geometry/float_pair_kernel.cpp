// With the edges p, q of A at a0, the edges r, s of B at b0, all in A's coordinates, d = a0 - b0,
// NA = p x q and NB = r x s, all fifteen determinants of a pair are sums of ten triple products, as
// in double_triangle_pair.cpp. Edges are differences of a triangle's own corners, and d is formed
// in double: all that becomes a float is as small as the triangles and their distance, wherever
// they are, and so are its errors.
//
// Bounds, with u = 2^-24. A computed vector has components of at most x, and errs by at most dx in
// each; X = x + dx bounds the true ones too.
//
// Input: a determinant of rows in [-1, 1] is linear in each entry, so largest where all are 1 or
// -1, and there it is at most 4. It is linear in its rows, so errors of the input change a triple
// product by at most 4 (dx Y Z + X dy Z + X Y dz).
// Arithmetic: with Y = Z = 1, a component ci of a cross product is at most 2, and the three
// together at most 4, by the same argument. It is 2.001 u + |ci| u off: two products and one
// difference. The dot product takes over 10.01 u XYZ of these, and rounds three products that sum
// to 4 XYZ, a sum of two that is at most that, and the result: 22.1 u XYZ. A determinant adds up to
// eight triple products of at most 4 XYZ each, along a tree of depth three: 12.01 u XYZ for each.
// Together below 34.2 u XYZ. So a triple product within a determinant is within
//     fx Y Z + X fy Z + X Y fz, fx = 4.01 dx + 11.45 u X,
// where 4.01 and 11.45 (for 4 and 11.4) leave room for the roundings of the bound itself: fewer
// than thirty, all of positive numbers.
//
// Errors of the input. An edge of A is rounded to a double and then to a float: dx = 1.0001 u x. An
// edge e of B is rotated in between, in doubles: that errs by edge_error |e|, and |e| is at most
// edge_stretch times the rotated edge. Poses for which the product is not below u / 1024 are not
// used, so that dx = 1.002 u x for B, too, and fx = 15.5 u x for both. The corner b0 is posed in
// doubles: each of three products goes through four roundings and has its entry's error, and the
// translation through one with its own error; d = a0 - b0 is then rounded to a double and to a
// float: dx = 1.0001 u x + point_error_reach |b0| + point_error.
//
// Underflow loses at most 2^-150 a product or conversion. Sizes are raised by 2^-120 and
// point_error by 2^-140, so that dx covers what is lost before the cross products. What is lost in
// them is multiplied by less than 2^40, the limit on sizes: below 2^-106 in all, and as little in
// the bounds: `underflow` covers it. Overflow to infinity in a size is beyond the limit; sizes
// within it overflow nothing. NaN of an input reaches the fifth edge determinant, which has all of
// them, and is looked for there: maxima may lose it.
#include "common/geometry/float_pair_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/geometry/float_pair_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Doubles = hn::ScalableTag<double>;
using V = hn::Vec<Floats>;
using VD = hn::Vec<Doubles>;

constexpr std::size_t lanes = hn::MaxLanes(Floats());
constexpr std::size_t block_pairs = 64; // Small enough for the first cache; any lanes divide it.
constexpr float size_max = 0x1p38F;

/// What a block of pairs needs of its triangles: rows of three numbers and one that is not used.
struct Rows {
    alignas(64) float p[4 * block_pairs];
    alignas(64) float q[4 * block_pairs];
    alignas(64) double e[4 * block_pairs]; ///< The edges of B, not yet rotated.
    alignas(64) double f[4 * block_pairs];
    alignas(64) double a0[4 * block_pairs];
    alignas(64) double b0[4 * block_pairs];
};

/// The x, y and z of a block of vectors.
struct Columns {
    alignas(64) float x[block_pairs];
    alignas(64) float y[block_pairs];
    alignas(64) float z[block_pairs];
};

/// What becomes of B's numbers in A's coordinates.
struct Posed {
    Columns r;
    Columns s;
    Columns d;
    alignas(64) float d_error[block_pairs]; ///< But for the last rounding.
};

/// Where the row of a block's pair is. Rows that become neighbours in a vector's columns lie apart,
/// so that columns are made of rows within 128 bits, which costs least.
constexpr std::size_t row_of(std::size_t pair) {
    const std::size_t lane = pair % lanes;
    return lanes < 4 ? pair : pair - lane + lane % 4 * (lanes / 4) + lane / 4;
}

#if HWY_MAX_BYTES >= 32

/// A corner, or a difference of two. Reads no further than the corners.
struct Corner {
    static constexpr hn::FixedTag<double, 4> row{};
    hn::Vec<hn::FixedTag<double, 4>> value;

    explicit Corner(const double* from) : value(hn::MaskedLoad(hn::FirstN(row, 3), row, from)) {}
    Corner(const Corner& from, const Corner& to) : value(hn::Sub(to.value, from.value)) {}
    void store(double* to) const { hn::Store(value, row, to); }
    void store(float* to) const {
        const hn::Rebind<float, hn::FixedTag<double, 4>> narrow;
        hn::Store(hn::DemoteTo(narrow, value), narrow, to);
    }
};

#else

struct Corner {
    double value[3];

    explicit Corner(const double* from) : value{from[0], from[1], from[2]} {}
    Corner(const Corner& from, const Corner& to)
        : value{to.value[0] - from.value[0],
                to.value[1] - from.value[1],
                to.value[2] - from.value[2]} {}
    template <class T>
    void store(T* to) const {
        for (std::size_t i = 0; i < 3; ++i) {
            to[i] = static_cast<T>(value[i]);
        }
        to[3] = 0;
    }
};

#endif

/// The first corner and the two edges from it.
template <class T>
HWY_INLINE void store_triangle(
    const FloatPairBody& body, std::uint32_t place, T* first, T* second, double* corner) {
    const std::uint32_t* t = body.triangles + 3 * std::size_t{place};
    const Corner x0(body.vertices + 3 * std::size_t{t[0]});
    const Corner x1(body.vertices + 3 * std::size_t{t[1]});
    const Corner x2(body.vertices + 3 * std::size_t{t[2]});
    Corner(x0, x1).store(first);
    Corner(x0, x2).store(second);
    x0.store(corner);
}

struct WideVectors {
    VD x;
    VD y;
    VD z;
};

#if HWY_MAX_BYTES >= 32

/// The columns of some rows, which `row_of` put a quarter of the lanes apart.
HWY_INLINE WideVectors load(const double* rows) {
    const Doubles dd;
    const VD v0 = hn::Load(dd, rows);
    const VD v1 = hn::Load(dd, rows + lanes);
    const VD v2 = hn::Load(dd, rows + 2 * lanes);
    const VD v3 = hn::Load(dd, rows + 3 * lanes);
    const VD xz01 = hn::InterleaveLower(dd, v0, v1);
    const VD xz23 = hn::InterleaveLower(dd, v2, v3);
    const VD yw01 = hn::InterleaveUpper(dd, v0, v1);
    const VD yw23 = hn::InterleaveUpper(dd, v2, v3);
    return {hn::OddEvenBlocks(hn::SwapAdjacentBlocks(xz23), xz01),
            hn::OddEvenBlocks(hn::SwapAdjacentBlocks(yw23), yw01),
            hn::OddEvenBlocks(xz23, hn::SwapAdjacentBlocks(xz01))};
}

#else

HWY_INLINE WideVectors load(const double* rows) {
    // Not the members of a struct: its default constructor would not be compiled for the target.
    VD x;
    VD y;
    VD z;
    VD unused;
    hn::LoadInterleaved4(Doubles(), rows, x, y, z, unused);
    return {x, y, z};
}

#endif

HWY_INLINE VD row_times(const double* row, const WideVectors& v) {
    const Doubles dd;
    return hn::Add(hn::Add(hn::Mul(hn::Set(dd, row[0]), v.x), hn::Mul(hn::Set(dd, row[1]), v.y)),
                   hn::Mul(hn::Set(dd, row[2]), v.z));
}

HWY_INLINE WideVectors rotated(const FloatPairPose& pose, const WideVectors& v) {
    const double* rows = pose.rotation.data();
    return {row_times(rows, v), row_times(rows + 3, v), row_times(rows + 6, v)};
}

HWY_INLINE void store_narrow(VD v, float* to) {
    const hn::Rebind<float, Doubles> narrow;
    hn::Store(hn::DemoteTo(narrow, v), narrow, to);
}

HWY_INLINE void store_narrow(const WideVectors& v, Columns& to, std::size_t first) {
    store_narrow(v.x, to.x + first);
    store_narrow(v.y, to.y + first);
    store_narrow(v.z, to.z + first);
}

HWY_INLINE void
pose_rows(const FloatPairPose& pose, const Rows& rows, std::size_t count, Posed& to) {
    const Doubles dd;
    constexpr std::size_t step = hn::MaxLanes(dd);
    const VD tx = hn::Set(dd, pose.translation[0]);
    const VD ty = hn::Set(dd, pose.translation[1]);
    const VD tz = hn::Set(dd, pose.translation[2]);
    for (std::size_t i = 0; i < count; i += step) {
        // The place of the first of the rows that become these lanes.
        const std::size_t place = 4 * row_of(i);
        store_narrow(rotated(pose, load(rows.e + place)), to.r, i);
        store_narrow(rotated(pose, load(rows.f + place)), to.s, i);
        const WideVectors a0 = load(rows.a0 + place);
        const WideVectors b0 = load(rows.b0 + place);
        const WideVectors b = rotated(pose, b0);
        store_narrow({hn::Sub(a0.x, hn::Add(b.x, tx)),
                      hn::Sub(a0.y, hn::Add(b.y, ty)),
                      hn::Sub(a0.z, hn::Add(b.z, tz))},
                     to.d,
                     i);
        const VD reach = hn::Max(hn::Max(hn::Abs(b0.x), hn::Abs(b0.y)), hn::Abs(b0.z));
        store_narrow(hn::Add(hn::Mul(hn::Set(dd, pose.point_error_reach), reach),
                             hn::Set(dd, pose.point_error)),
                     to.d_error + i);
    }
}

struct Vectors {
    V x;
    V y;
    V z;
};

HWY_INLINE V largest_of(const Vectors& v) {
    return hn::Max(hn::Max(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
}

HWY_INLINE Vectors cross(const Vectors& a, const Vectors& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
            hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

HWY_INLINE V dot(const Vectors& a, const Vectors& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE Vectors load(const float* rows) {
    const Floats df;
    return {hn::Load(df, rows), hn::Load(df, rows + 1), hn::Load(df, rows + 2)};
}

#else

HWY_INLINE Vectors load(const float* rows) {
    const Floats df;
    const hn::Repartition<double, Floats> pairs;
    const V v0 = hn::Load(df, rows);
    const V v1 = hn::Load(df, rows + lanes);
    const V v2 = hn::Load(df, rows + 2 * lanes);
    const V v3 = hn::Load(df, rows + 3 * lanes);
    const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(df, v0, v1));
    const auto xy23 = hn::BitCast(pairs, hn::InterleaveLower(df, v2, v3));
    const auto z01 = hn::BitCast(pairs, hn::InterleaveUpper(df, v0, v1));
    const auto z23 = hn::BitCast(pairs, hn::InterleaveUpper(df, v2, v3));
    return {hn::BitCast(df, hn::InterleaveLower(pairs, xy01, xy23)),
            hn::BitCast(df, hn::InterleaveUpper(pairs, xy01, xy23)),
            hn::BitCast(df, hn::InterleaveLower(pairs, z01, z23))};
}

#endif

HWY_INLINE Vectors load(const Columns& columns, std::size_t first) {
    const Floats df;
    return {hn::Load(df, columns.x + first),
            hn::Load(df, columns.y + first),
            hn::Load(df, columns.z + first)};
}

/// X and fx above.
struct Extent {
    V size;
    V fuzz;
};

HWY_INLINE V triple_error(const Extent& x, const Extent& y, const Extent& z) {
    return hn::Add(hn::Mul(hn::Mul(x.fuzz, y.size), z.size),
                   hn::Mul(x.size, hn::Add(hn::Mul(y.fuzz, z.size), hn::Mul(y.size, z.fuzz))));
}

/// The same with the second kind twice.
HWY_INLINE V triple_error(const Extent& x, const Extent& y) {
    const V twice = hn::Mul(hn::Add(x.size, x.size), y.fuzz);
    return hn::Mul(y.size, hn::Add(hn::Mul(x.fuzz, y.size), twice));
}

/// Whether a value is proven positive or negative: in the sign bits, which are set if so. A
/// difference of floats has the sign of the exact one, since underflow is gradual.
struct Sign {
    V positive;
    V negative;
};

HWY_INLINE Sign sign(V value, V error) {
    return {hn::Sub(error, value), hn::Add(error, value)};
}

HWY_INLINE Sign opposite(const Sign& s) {
    return {s.negative, s.positive};
}

/// What is proven so far: in the sign bits.
struct Proofs {
    V all_miss;
    V any_pierces;
};

/// One edge with the sides of its ends, and those against the other's three edges: `judge_edge` of
/// double_triangle_pair.cpp.
HWY_INLINE void judge_edge(
    const Sign& from, const Sign& to, const Sign& x, const Sign& y, const Sign& z, Proofs& proofs) {
    using hn::And;
    using hn::Or;
    const V one_sided = Or(And(from.positive, to.positive), And(from.negative, to.negative));
    const V crosses = Or(And(from.positive, to.negative), And(from.negative, to.positive));
    const V passes =
        And(Or(Or(x.positive, y.positive), z.positive), Or(Or(x.negative, y.negative), z.negative));
    const V encircled = Or(And(And(x.positive, y.positive), z.positive),
                           And(And(x.negative, y.negative), z.negative));
    proofs.all_miss = And(proofs.all_miss, Or(one_sided, passes));
    proofs.any_pierces = Or(proofs.any_pierces, And(crosses, encircled));
}

HWY_INLINE V all_agree(const Sign (&s)[3]) {
    return hn::Or(hn::And(hn::And(s[0].positive, s[1].positive), s[2].positive),
                  hn::And(hn::And(s[0].negative, s[1].negative), s[2].negative));
}

HWY_INLINE V any_proven(const Sign (&s)[3]) {
    return hn::Or(hn::Or(hn::Or(s[0].positive, s[1].positive), s[2].positive),
                  hn::Or(hn::Or(s[0].negative, s[1].negative), s[2].negative));
}

/// `decide` of double_triangle_pair.cpp, as a FloatVerdict in each lane.
HWY_INLINE hn::Vec<hn::RebindToSigned<Floats>>
decide(const Sign (&a_side)[3], const Sign (&b_side)[3], const Sign (&across)[9]) {
    const hn::RebindToSigned<Floats> di;
    const hn::RebindToUnsigned<Floats> du;
    const Sign* o = across;
    Proofs proofs{hn::BitCast(Floats(), hn::Set(du, 0x80000000u)), hn::Zero(Floats())};
    judge_edge(a_side[0], a_side[1], o[0], o[1], o[2], proofs);
    judge_edge(a_side[1], a_side[2], o[3], o[4], o[5], proofs);
    judge_edge(a_side[2], a_side[0], o[6], o[7], o[8], proofs);
    judge_edge(b_side[0], b_side[1], o[0], o[3], o[6], proofs);
    judge_edge(b_side[1], b_side[2], o[1], o[4], o[7], proofs);
    judge_edge(b_side[2], b_side[0], o[2], o[5], o[8], proofs);
    const V separate = hn::Or(proofs.all_miss, hn::Or(all_agree(a_side), all_agree(b_side)));
    const V proper = hn::And(proofs.any_pierces, hn::And(any_proven(a_side), any_proven(b_side)));
    const auto one_if = [&](V v) { return hn::ShiftRight<31>(hn::BitCast(du, v)); };
    return hn::BitCast(di, hn::Add(one_if(separate), hn::Add(one_if(proper), one_if(proper))));
}

/// The verdicts of as many pairs as there are lanes, from the place of the first in its block.
HWY_INLINE hn::Vec<hn::RebindToSigned<Floats>>
classify_lanes(const FloatPairPose& pose, const Rows& rows, const Posed& posed, std::size_t first) {
    const Floats df;
    const Vectors p = load(rows.p + 4 * first);
    const Vectors q = load(rows.q + 4 * first);
    const Vectors r = load(posed.r, first);
    const Vectors s = load(posed.s, first);
    const Vectors d = load(posed.d, first);

    const V size_weight = hn::Set(df, pose.size_weight);
    const V least = hn::Set(df, 0x1p-120F);
    const V size_a = hn::Add(hn::Max(largest_of(p), largest_of(q)), least);
    const V size_b = hn::Add(hn::Max(largest_of(r), largest_of(s)), least);
    const V error_d = hn::Load(df, posed.d_error + first);
    const V size_d = hn::Add(largest_of(d), error_d);
    const Extent of_a{size_a, hn::Mul(size_weight, size_a)};
    const Extent of_b{size_b, hn::Mul(size_weight, size_b)};
    const Extent of_d{
        size_d,
        hn::Add(hn::Mul(size_weight, size_d), hn::Mul(hn::Set(df, pose.error_weight), error_d))};

    const V underflow = hn::Set(df, pose.underflow);
    const V abb = triple_error(of_a, of_b);
    const V aab = triple_error(of_b, of_a);
    const V bbd = hn::Add(triple_error(of_d, of_b), underflow);
    const V aad = hn::Add(triple_error(of_d, of_a), underflow);
    const V abd = hn::Add(triple_error(of_a, of_b, of_d), underflow);

    const Vectors nb = cross(r, s);
    const V nbd = dot(nb, d);
    const V nbp = dot(nb, p);
    const V nbq = dot(nb, q);
    const V bbd_abb = hn::Add(bbd, abb);
    const Sign a_side[3] = {
        sign(nbd, bbd), sign(hn::Add(nbd, nbp), bbd_abb), sign(hn::Add(nbd, nbq), bbd_abb)};

    const Vectors na = cross(p, q);
    const V nad = dot(na, d);
    const V nar = dot(na, r);
    const V nas = dot(na, s);
    const V aad_aab = hn::Add(aad, aab);
    const Sign b_side[3] = {opposite(sign(nad, aad)),
                            sign(hn::Sub(nar, nad), aad_aab),
                            sign(hn::Sub(nas, nad), aad_aab)};

    const V pr = dot(cross(p, r), d);
    const V ps = dot(cross(p, s), d);
    const V qr = dot(cross(q, r), d);
    const V qs = dot(cross(q, s), d);
    const V two_abd = hn::Add(abd, abd);
    const V with_nb = hn::Add(two_abd, abb);
    const V with_na = hn::Add(two_abd, aab);
    const V middle = hn::Add(hn::Add(hn::Sub(qs, qr), hn::Sub(pr, ps)),
                             hn::Add(hn::Sub(nas, nar), hn::Sub(nbq, nbp)));
    const Sign across[9] = {sign(pr, abd),
                            sign(hn::Add(hn::Sub(ps, pr), nbp), with_nb),
                            opposite(sign(ps, abd)),
                            sign(hn::Add(hn::Sub(qr, pr), nar), with_na),
                            sign(middle, hn::Add(hn::Add(with_nb, with_na), hn::Add(abb, aab))),
                            opposite(sign(hn::Add(hn::Sub(qs, ps), nas), with_na)),
                            opposite(sign(qr, abd)),
                            sign(hn::Sub(hn::Sub(qr, qs), nbq), with_nb),
                            sign(qs, abd)};

    const V largest = hn::Max(hn::Max(size_a, size_b), size_d);
    const auto is_usable = hn::And(hn::Lt(largest, hn::Set(df, size_max)), hn::Eq(middle, middle));
    return hn::IfThenElseZero(hn::RebindMask(hn::RebindToSigned<Floats>(), is_usable),
                              decide(a_side, b_side, across));
}

void classify_block(const FloatPairPose& pose,
                    const FloatPairBody& a,
                    const FloatPairBody& b,
                    const std::uint32_t* candidates,
                    std::size_t count,
                    std::uint8_t* verdicts) {
    const hn::Rebind<std::uint8_t, Floats> bytes;
    const std::size_t whole = (count + lanes - 1) / lanes * lanes;
    Rows rows;
    for (std::size_t i = 0; i < whole; ++i) {
        // The last one stands in where lanes are left over.
        const std::uint32_t* candidate = candidates + 2 * (i < count ? i : count - 1);
        const std::size_t place = 4 * row_of(i);
        store_triangle(a, candidate[0], rows.p + place, rows.q + place, rows.a0 + place);
        store_triangle(b, candidate[1], rows.e + place, rows.f + place, rows.b0 + place);
    }
    Posed posed;
    pose_rows(pose, rows, whole, posed);
    alignas(64) std::uint8_t found[block_pairs];
    for (std::size_t i = 0; i < whole; i += lanes) {
        hn::Store(hn::DemoteTo(bytes, classify_lanes(pose, rows, posed, i)), bytes, found + i);
    }
    for (std::size_t i = 0; i < count; ++i) {
        verdicts[i] = found[i];
    }
}

void classify_all(const FloatPairPose& pose,
                  const FloatPairBody& a,
                  const FloatPairBody& b,
                  const std::uint32_t* candidates,
                  std::size_t count,
                  std::uint8_t* verdicts) {
    for (std::size_t i = 0; i < count; i += block_pairs) {
        const std::size_t size = count - i < block_pairs ? count - i : block_pairs;
        classify_block(pose, a, b, candidates + 2 * i, size, verdicts + i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(classify_all);

void classify_in_floats(const FloatPairPose& pose,
                        const FloatPairBody& a,
                        const FloatPairBody& b,
                        const std::uint32_t* candidates,
                        std::size_t count,
                        std::uint8_t* verdicts) {
    HWY_DYNAMIC_DISPATCH(classify_all)(pose, a, b, candidates, count, verdicts);
}

} // namespace cd

#endif
