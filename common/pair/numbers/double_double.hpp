// Numbers of twice double precision, as unevaluated sums of two doubles.
#pragma once

namespace cd {

/// The number high + low, where high is the rounded sum: |low| <= u |high|, u = 2^-53.
///
/// The bounds below hold where nothing overflows. Underflow adds at most a few multiples of 2^-1074
/// to the error of a product; callers use magnitudes where that is negligible. Infinity and NaN
/// make `low` NaN at the latest, so that no comparison proves a sign.
struct DoubleDouble {
    double high = 0;
    double low = 0;
};

/// Bounds the relative error of a product, and the error of a sum relative to |left| + |right|. A
/// quotient errs by at most twice this, relatively.
inline constexpr double double_double_error = 0x1p-102; // 16 u^2.

/// Bounds of lengths between which neither overflow nor underflow matters: products of four lengths
/// stay far below 2^996, and underflow's effect, some 2^-1074, far below any error bound in use.
inline constexpr double double_double_length_least = 0x1p-200;
inline constexpr double double_double_length_most = 0x1p200;

/// Returns left + right without any error (Knuth's TwoSum).
[[nodiscard]] inline DoubleDouble exact_sum(double left, double right) {
    const double sum = left + right;
    const double right_part = sum - left;
    const double left_part = sum - right_part;
    return {sum, (left - left_part) + (right - right_part)};
}

/// Returns high + low without any error, for |high| >= |low| (Dekker's Fast2Sum).
[[nodiscard]] inline DoubleDouble exact_sum_ordered(double high, double low) {
    const double sum = high + low;
    return {sum, low - (sum - high)};
}

/// Returns left * right without any error but underflow, for magnitudes below 2^996 (Dekker's
/// product with Veltkamp's splitting). Avoids fused multiply-add, which is a slow call where the
/// processor has none.
[[nodiscard]] inline DoubleDouble exact_product(double left, double right) {
    constexpr double splitter = 0x1p27 + 1;
    const double left_scaled = splitter * left;
    const double left_high = left_scaled - (left_scaled - left);
    const double left_low = left - left_high;
    const double right_scaled = splitter * right;
    const double right_high = right_scaled - (right_scaled - right);
    const double right_low = right - right_high;
    const double product = left * right;
    const double error =
        left_low * right_low -
        (((product - left_high * right_high) - left_low * right_high) - left_high * right_low);
    return {product, error};
}

[[nodiscard]] inline DoubleDouble operator-(const DoubleDouble& value) {
    return {-value.high, -value.low};
}

/// Adds with two roundings: of the sum of both low parts, at most u (|l| + |r|), and of the total
/// low part, at most 2 u (|l| + |r|). Each rounding errs by at most u of these.
[[nodiscard]] inline DoubleDouble operator+(const DoubleDouble& l, const DoubleDouble& r) {
    const DoubleDouble high = exact_sum(l.high, r.high);
    return exact_sum(high.high, high.low + (l.low + r.low));
}

[[nodiscard]] inline DoubleDouble operator-(const DoubleDouble& l, const DoubleDouble& r) {
    return l + -r;
}

/// Omits low times low, u^2. Rounds two products of at most u, their sum of at most 2 u, and the
/// sum with the high product's error, at most 3 u. Each errs by u relatively: 8 u^2 in all.
[[nodiscard]] inline DoubleDouble operator*(const DoubleDouble& l, const DoubleDouble& r) {
    const DoubleDouble high = exact_product(l.high, r.high);
    return exact_sum_ordered(high.high, high.low + (l.high * r.low + l.low * r.high));
}

[[nodiscard]] inline DoubleDouble operator*(const DoubleDouble& l, double r) {
    const DoubleDouble high = exact_product(l.high, r);
    return exact_sum_ordered(high.high, high.low + l.low * r);
}

/// The first quotient errs by at most 4 u. Its remainder is known to 9 u^2 (a product and a sum)
/// and is at most 4 u; its quotient errs by 3 u of that: 21 u^2 and terms of third order.
[[nodiscard]] inline DoubleDouble operator/(const DoubleDouble& l, const DoubleDouble& r) {
    const double first = l.high / r.high;
    const DoubleDouble rest = l - r * first;
    return exact_sum_ordered(first, rest.high / r.high);
}

} // namespace cd
