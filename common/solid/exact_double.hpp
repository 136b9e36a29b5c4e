// Doubles that record whether they are exact: short numbers decide ties without integers.
#pragma once

#include "common/pair/numbers/double_double.hpp"

#include <cmath>
#include <optional>

namespace cd {

/// A value, and whether every operation that led to it was exact.
struct ExactDouble {
    double value = 0;
    bool is_exact = true;

    [[nodiscard]] std::optional<int> sign() const {
        return is_exact ? std::optional(value > 0 ? 1 : value < 0 ? -1 : 0) : std::nullopt;
    }
};

[[nodiscard]] inline ExactDouble operator+(const ExactDouble& l, const ExactDouble& r) {
    const DoubleDouble sum = exact_sum(l.value, r.value); // On overflow, `low` is NaN.
    return {sum.high, l.is_exact && r.is_exact && sum.low == 0};
}

[[nodiscard]] inline ExactDouble operator-(const ExactDouble& l, const ExactDouble& r) {
    return l + ExactDouble{-r.value, r.is_exact};
}

[[nodiscard]] inline ExactDouble operator*(const ExactDouble& l, const ExactDouble& r) {
    const DoubleDouble product = exact_product(l.value, r.value);
    // Above this bound, the product's `low` does not underflow.
    const bool in_range = l.value == 0 || r.value == 0 || std::abs(product.high) > 0x1p-900;
    return {product.high, l.is_exact && r.is_exact && in_range && product.low == 0};
}

} // namespace cd
