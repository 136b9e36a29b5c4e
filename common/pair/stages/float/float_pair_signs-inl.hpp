// Computes the fifteen determinants, one pair per SIMD lane, and the signs that the bounds of
// float_pair_kernel.cpp prove. Compiled for every target.

// Highway's include guard: once per target.
#if defined(CD_FLOAT_PAIR_SIGNS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_FLOAT_PAIR_SIGNS_INL_HPP
#undef CD_FLOAT_PAIR_SIGNS_INL_HPP
#else
#define CD_FLOAT_PAIR_SIGNS_INL_HPP
#endif

#include "common/pair/stages/float/float_pair_columns-inl.hpp"
#include "common/pair/stages/float/float_pair_decide.hpp"
#include "common/pair/stages/float/float_pair_rows-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

/// Writes the signs of as many pairs as a SIMD vector has lanes, from one byte of each row on.
class SignWriter {
  public:
    HWY_INLINE SignWriter(SignBits& to, std::size_t byte) : to_(to), at_(byte) {}

    template <PairSign sign>
    HWY_INLINE void write(V value, V error) const {
        const Floats df;
        constexpr auto row = static_cast<std::size_t>(sign);
        hn::StoreMaskBits(df, hn::Gt(value, error), to_.positive[row] + at_);
        hn::StoreMaskBits(df, hn::Lt(value, hn::Neg(error)), to_.negative[row] + at_);
    }
    HWY_INLINE void write_usable(V size, V value) const {
        const Floats df;
        const auto known = hn::And(hn::Lt(size, hn::Set(df, 0x1p76F)), hn::Eq(value, value));
        hn::StoreMaskBits(df, known, to_.usable + at_);
    }

  private:
    SignBits& to_;
    std::size_t at_;
};

HWY_NOINLINE void write_signs(const FloatPairPose& pose, const Rows& rows, SignWriter to) {
    const Floats df;
    const Columns p = load_columns(rows.p);
    const Columns q = load_columns(rows.q);
    const Columns r = turned(pose, load_columns(rows.e));
    const Columns s = turned(pose, load_columns(rows.f));
    const Columns d = load_columns(rows.d);

    const V least = hn::Set(df, 0x1p-64F);
    const V aa = hn::Add(hn::Max(square(p), square(q)), least);
    const V bb = hn::Add(hn::Max(square(r), square(s)), least);
    const V dd = hn::Add(square(d), least);
    const V d_error = hn::Load(df, rows.d_error);
    const V size_a = hn::Sqrt(aa);
    const V size_b = hn::Sqrt(bb);
    const V size_d = hn::Add(hn::Sqrt(dd), d_error);

    const V ab = hn::Mul(size_a, size_b);
    const V fixed = hn::Mul(hn::Set(df, pose.weight_error), d_error);
    const auto with_d = [&](float weight) {
        return hn::Add(hn::Mul(hn::Set(df, pose.weight_d + weight), size_d), fixed);
    };
    const V bbd = hn::Mul(bb, with_d(2 * pose.weight_b));
    const V aad = hn::Mul(aa, with_d(2 * pose.weight_a));
    const V abd = hn::Mul(ab, with_d(pose.weight_a + pose.weight_b));
    const V abb = hn::Mul(ab, hn::Mul(size_b, hn::Set(df, pose.weight_a + 2 * pose.weight_b)));
    const V aab = hn::Mul(ab, hn::Mul(size_a, hn::Set(df, 2 * pose.weight_a + pose.weight_b)));

    const Columns nb = cross(r, s);
    const V nbd = dot(nb, d);
    const V nbp = dot(nb, p);
    const V nbq = dot(nb, q);
    const V bbd_abb = hn::Add(bbd, abb);
    to.write<PairSign::ASide0>(nbd, bbd);
    to.write<PairSign::ASide1>(hn::Add(nbd, nbp), bbd_abb);
    to.write<PairSign::ASide2>(hn::Add(nbd, nbq), bbd_abb);

    const Columns na = cross(p, q);
    const V nad = dot(na, d);
    const V nar = dot(na, r);
    const V nas = dot(na, s);
    const V aad_aab = hn::Add(aad, aab);
    to.write<PairSign::BSide0Opposite>(nad, aad);
    to.write<PairSign::BSide1>(hn::Sub(nar, nad), aad_aab);
    to.write<PairSign::BSide2>(hn::Sub(nas, nad), aad_aab);

    const Columns rd = cross(r, d);
    const V pr = dot(rd, p);
    const V qr = dot(rd, q);
    const Columns sd = cross(s, d);
    const V ps = dot(sd, p);
    const V qs = dot(sd, q);
    const V two_abd = hn::Add(abd, abd);
    const V with_nb = hn::Add(two_abd, abb);
    const V with_na = hn::Add(two_abd, aab);
    const V p_turns = hn::Sub(ps, pr);
    const V q_turns = hn::Sub(qr, qs);
    const V middle =
        hn::Sub(hn::Add(hn::Sub(nas, nar), hn::Sub(nbq, nbp)), hn::Add(p_turns, q_turns));
    to.write<PairSign::Across0>(pr, abd);
    to.write<PairSign::Across1>(hn::Add(p_turns, nbp), with_nb);
    to.write<PairSign::Across2Opposite>(ps, abd);
    to.write<PairSign::Across3>(hn::Add(hn::Sub(qr, pr), nar), with_na);
    to.write<PairSign::Across4>(middle, hn::Add(hn::Add(with_nb, with_na), hn::Add(abb, aab)));
    to.write<PairSign::Across5>(hn::Sub(hn::Sub(ps, qs), nas), with_na);
    to.write<PairSign::Across6Opposite>(qr, abd);
    to.write<PairSign::Across7>(hn::Sub(q_turns, nbq), with_nb);
    to.write<PairSign::Across8>(qs, abd);
    to.write_usable(hn::Max(hn::Max(aa, bb), dd), middle);
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
