// Proves that exact numbers made from doubles stay exact, and that a ratio of integers is rounded
// to the nearest finite double, ties to even, from denormals to the largest.
#include "common/pair/numbers/dyadic.hpp"

#include "tests/support/clipping_oracle.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace cd::tests {

namespace {

using Int = boost::multiprecision::cpp_int;
constexpr double largest = std::numeric_limits<double>::max();

Rational power_of_two(int exponent) {
    const Int power = Int(1) << std::abs(exponent);
    return exponent >= 0 ? Rational(power) : Rational(1) / Rational(power);
}

Rational value_of(const ExactInt& n, const ExactInt& d, int exponent) {
    return Rational(Int(n)) / Rational(Int(d)) * power_of_two(exponent);
}

ExactInt random_int(std::mt19937_64& random, unsigned bits_max) {
    const auto bits = static_cast<unsigned>(1 + random() % bits_max);
    ExactInt value = 1;
    for (unsigned i = 1; i < bits; i += 64) {
        value = (value << 64) + random();
    }
    value >>= msb(value) + 1 - bits;
    return random() % 2 == 0 ? value : ExactInt(-value);
}

double random_double(std::mt19937_64& random) {
    for (;;) {
        const auto value = std::bit_cast<double>(random());
        if (std::isfinite(value)) {
            return value;
        }
    }
}

} // namespace

TEST(Dyadic, EveryRatioIsRoundedToTheNearest) {
    std::mt19937_64 random(1);
    for (int round = 0; round < 5'000; ++round) {
        const ExactInt n = random_int(random, round % 2 == 0 ? 60 : 700);
        const ExactInt d = random_int(random, round % 3 == 0 ? 3 : 400);
        const int exponent = static_cast<int>(random() % 2600) - 1300;
        SCOPED_TRACE(testing::Message() << n << " / " << d << " * 2^" << exponent);
        ASSERT_TRUE(is_nearest_double(nearest_double(n, d, exponent), value_of(n, d, exponent)));
    }
}

TEST(Dyadic, TiesRoundToEvenAndNearTiesToTheNearest) {
    std::mt19937_64 random(2);
    for (int round = 0; round < 5'000; ++round) {
        // Twice a mantissa plus 1, including denormals and values that round up to a power of two.
        const std::uint64_t mantissa = round % 7 == 0 ? (1ull << 53) - 1 : random() >> 11;
        const ExactInt middle = (ExactInt(mantissa) << 1) + 1;
        const int exponent = round % 2 == 0 ? -1075 : static_cast<int>(random() % 2000) - 1070;
        // The midpoint as a fraction over an odd d, exact or off by the least amount.
        const ExactInt d = (random_int(random, 200) << 1) + 1;
        for (const int off : {-1, 0, 1}) {
            const ExactInt n = middle * d + off;
            SCOPED_TRACE(testing::Message() << mantissa << ", " << exponent << ", off " << off);
            ASSERT_TRUE(
                is_nearest_double(nearest_double(n, d, exponent), value_of(n, d, exponent)));
        }
    }
}

TEST(Dyadic, TheEndsOfTheRangeAreRoundedCorrectly) {
    constexpr double least = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(nearest_double(1, 1, -1074), least);
    EXPECT_EQ(nearest_double(1, 1, -1075), 0);
    EXPECT_EQ(nearest_double(-1, 1, -1075), 0);
    EXPECT_FALSE(std::signbit(nearest_double(-1, 1, -1075)));
    EXPECT_EQ(nearest_double(1000001, 1000000, -1075), least);
    EXPECT_EQ(nearest_double(1, -3, -5000), 0);
    EXPECT_EQ(nearest_double(0, -3, 5000), 0);
    EXPECT_EQ(nearest_double(1, 1, 1024), largest);
    EXPECT_EQ(nearest_double(-1, 1, 5000), -largest);
    EXPECT_EQ(nearest_double(1, 1, 1023), 0x1p1023);
}

TEST(Dyadic, ADoubleComesBack) {
    std::mt19937_64 random(3);
    for (int round = 0; round < 20'000; ++round) {
        const double value = random_double(random);
        const Dyadic exact = to_dyadic(value);
        EXPECT_EQ(nearest_double(exact.mantissa, 1, exact.exponent), value);
    }
}

TEST(Dyadic, SumsAndProductsAreExact) {
    std::mt19937_64 random(4);
    const auto rational = [](const Dyadic& d) { return value_of(d.mantissa, 1, d.exponent); };
    for (int round = 0; round < 300; ++round) {
        const double x = round % 9 == 0 ? 0 : random_double(random);
        const double y = round % 10 == 0 ? 0 : random_double(random);
        EXPECT_EQ(rational(to_dyadic(x) + to_dyadic(y)), Rational(x) + Rational(y));
        EXPECT_EQ(rational(to_dyadic(x) - to_dyadic(y)), Rational(x) - Rational(y));
        EXPECT_EQ(rational(to_dyadic(x) * to_dyadic(y)), Rational(x) * Rational(y));
    }
}

} // namespace cd::tests
