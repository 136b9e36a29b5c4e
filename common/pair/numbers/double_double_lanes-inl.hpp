// The arithmetic of double_double.hpp, one number per SIMD lane, by the same operations; so the
// same bounds hold. Only exact products may differ in their steps, not in their value. Compiled for
// every target.

// Highway's include guard: once per target.
#if defined(CD_DOUBLE_DOUBLE_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_DOUBLE_DOUBLE_LANES_INL_HPP
#undef CD_DOUBLE_DOUBLE_LANES_INL_HPP
#else
#define CD_DOUBLE_DOUBLE_LANES_INL_HPP
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace double_double_lanes {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using V = hn::Vec<Doubles>;
using M = hn::Mask<Doubles>;

// Where GCC gives vectors a default constructor, as on NEON, only code compiled for the target may
// call that. So structures that are filled later declare a default constructor of their own.

HWY_INLINE V set(double value) {
    return hn::Set(Doubles(), value);
}

HWY_INLINE M always() {
    return hn::Eq(hn::Zero(Doubles()), hn::Zero(Doubles()));
}

/// Selects lanes of `yes` where `which` is set, else of `no`.
HWY_INLINE V choose(M which, V yes, V no) {
    return hn::IfThenElse(which, yes, no);
}

HWY_INLINE M choose(M which, M yes, M no) {
    return hn::Or(hn::And(which, yes), hn::AndNot(which, no));
}

/// The number high + low in each lane.
struct Number {
    V high;
    V low;

    HWY_INLINE Number() {}
    HWY_INLINE Number(V its_high, V its_low) : high(its_high), low(its_low) {}
};

HWY_INLINE Number choose(M which, const Number& yes, const Number& no) {
    return {choose(which, yes.high, no.high), choose(which, yes.low, no.low)};
}

HWY_INLINE M is_equal(const Number& l, const Number& r) {
    return hn::And(hn::Eq(l.high, r.high), hn::Eq(l.low, r.low));
}

HWY_INLINE Number exact_sum(V left, V right) {
    const V sum = hn::Add(left, right);
    const V right_part = hn::Sub(sum, left);
    const V left_part = hn::Sub(sum, right_part);
    return {sum, hn::Add(hn::Sub(left, left_part), hn::Sub(right, right_part))};
}

HWY_INLINE Number exact_sum_ordered(V high, V low) {
    const V sum = hn::Add(high, low);
    return {sum, hn::Sub(low, hn::Sub(sum, high))};
}

HWY_INLINE Number exact_product(V left, V right) {
    const V product = hn::Mul(left, right);
#if HWY_NATIVE_FMA
    return {product, hn::MulSub(left, right, product)};
#else
    const V splitter = set(0x1p27 + 1);
    const V left_scaled = hn::Mul(splitter, left);
    const V left_high = hn::Sub(left_scaled, hn::Sub(left_scaled, left));
    const V left_low = hn::Sub(left, left_high);
    const V right_scaled = hn::Mul(splitter, right);
    const V right_high = hn::Sub(right_scaled, hn::Sub(right_scaled, right));
    const V right_low = hn::Sub(right, right_high);
    const V rest = hn::Sub(
        hn::Sub(hn::Sub(product, hn::Mul(left_high, right_high)), hn::Mul(left_low, right_high)),
        hn::Mul(left_high, right_low));
    return {product, hn::Sub(hn::Mul(left_low, right_low), rest)};
#endif
}

HWY_INLINE Number operator-(const Number& value) {
    return {hn::Neg(value.high), hn::Neg(value.low)};
}

HWY_INLINE Number operator+(const Number& l, const Number& r) {
    const Number high = exact_sum(l.high, r.high);
    return exact_sum(high.high, hn::Add(high.low, hn::Add(l.low, r.low)));
}

HWY_INLINE Number operator-(const Number& l, const Number& r) {
    return l + -r;
}

HWY_INLINE Number operator*(const Number& l, const Number& r) {
    const Number high = exact_product(l.high, r.high);
    const V low = hn::Add(hn::Mul(l.high, r.low), hn::Mul(l.low, r.high));
    return exact_sum_ordered(high.high, hn::Add(high.low, low));
}

HWY_INLINE Number operator*(const Number& l, V r) {
    const Number high = exact_product(l.high, r);
    return exact_sum_ordered(high.high, hn::Add(high.low, hn::Mul(l.low, r)));
}

HWY_INLINE Number operator/(const Number& l, const Number& r) {
    const V first = hn::Div(l.high, r.high);
    const Number rest = l - r * first;
    return exact_sum_ordered(first, hn::Div(rest.high, r.high));
}

/// A vector of three components.
struct Vector {
    Number at[3];

    HWY_INLINE Vector() {}
    HWY_INLINE Vector(const Number& x, const Number& y, const Number& z) : at{x, y, z} {}
};

HWY_INLINE Vector operator-(const Vector& l, const Vector& r) {
    return {l.at[0] - r.at[0], l.at[1] - r.at[1], l.at[2] - r.at[2]};
}

HWY_INLINE Number dot(const Vector& l, const Vector& r) {
    return l.at[0] * r.at[0] + l.at[1] * r.at[1] + l.at[2] * r.at[2];
}

HWY_INLINE Vector cross(const Vector& l, const Vector& r) {
    return {l.at[1] * r.at[2] - l.at[2] * r.at[1],
            l.at[2] * r.at[0] - l.at[0] * r.at[2],
            l.at[0] * r.at[1] - l.at[1] * r.at[0]};
}

} // namespace double_double_lanes
} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
