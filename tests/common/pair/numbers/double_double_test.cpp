// Proves the error bounds of double-double arithmetic against rational arithmetic.
#include "common/pair/numbers/double_double.hpp"

#include "tests/support/clipping_oracle.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace cd::tests {

namespace {

Rational value_of(const DoubleDouble& x) {
    return Rational(x.high) + Rational(x.low);
}

/// Makes numbers that are often short, or with a low part near a half ulp or far below it.
DoubleDouble make_double_double(std::mt19937_64& random) {
    const auto part = [&](double reach) {
        const double value = uniform(random, -reach, reach);
        return random() % 4 == 0 ? std::ldexp(std::round(std::ldexp(value, 3)), -3) : value;
    };
    const int exponent = static_cast<int>(random() % 12) - 6;
    const double high = std::ldexp(part(1), exponent);
    const double half_step = (std::nextafter(std::abs(high), 1e9) - std::abs(high)) / 2;
    double low = random() % 3 == 0 ? half_step * (1 - 0x1p-53) : half_step * uniform(random, -1, 1);
    low = random() % 4 == 0 ? std::ldexp(low, -static_cast<int>(random() % 60)) : low;
    return exact_sum(high, random() % 8 == 0 ? 0.0 : low);
}

} // namespace

TEST(DoubleDouble, SumsAndProductsOfDoublesAreExact) {
    std::mt19937_64 random(1);
    for (int round = 0; round < 3000; ++round) {
        const double x = std::ldexp(uniform(random, -1, 1), static_cast<int>(random() % 200) - 100);
        const double y = std::ldexp(uniform(random, -1, 1), static_cast<int>(random() % 200) - 100);
        ASSERT_EQ(value_of(exact_sum(x, y)), Rational(x) + Rational(y));
        ASSERT_EQ(value_of(exact_product(x, y)), Rational(x) * Rational(y));
        ASSERT_EQ(exact_sum(x, y).high, x + y);
    }
}

TEST(DoubleDouble, OperationsErrByLessThanTheirBounds) {
    std::mt19937_64 random(2);
    const Rational bound(double_double_error);
    Rational worst = 0;
    for (int round = 0; round < 6000; ++round) {
        const DoubleDouble x = make_double_double(random);
        // Some sums nearly cancel.
        DoubleDouble y = make_double_double(random);
        if (round % 3 == 0) {
            y = exact_sum(-x.high * (1 + 0x1p-52 * static_cast<double>(random() % 3)), y.low);
        }
        const Rational exact_x = value_of(x);
        const Rational exact_y = value_of(y);
        const auto check =
            [&](const DoubleDouble& result, const Rational& exact, const Rational& by) {
                const Rational error = abs(value_of(result) - exact);
                ASSERT_LE(error, by * bound) << round;
                ASSERT_EQ(result.high, result.high + result.low) << round;
                if (by != 0) {
                    worst = std::max(worst, Rational(error / by));
                }
            };
        check(x + y, exact_x + exact_y, abs(exact_x) + abs(exact_y));
        check(x - y, exact_x - exact_y, abs(exact_x) + abs(exact_y));
        check(x * y, exact_x * exact_y, abs(exact_x * exact_y));
        check(x * y.high, exact_x * Rational(y.high), abs(exact_x * Rational(y.high)));
        if (y.high != 0) {
            check(x / y, exact_x / exact_y, 2 * abs(exact_x / exact_y));
        }
    }
    // The rounds are hard enough to cause errors of a few u^2.
    EXPECT_GT(worst, Rational(0x1p-105));
}

} // namespace cd::tests
