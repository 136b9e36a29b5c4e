// Proves that fixed-size integers compute exactly what unlimited ones do, up to the largest numbers
// they support.
#include "common/pair/numbers/wide_int.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <array>
#include <random>

namespace cd::tests {

namespace {

using Unlimited = boost::multiprecision::cpp_int;

template <std::size_t n>
Unlimited unlimited(const WideInt<n>& value) {
    Unlimited sum = 0;
    for (std::size_t i = n; i-- > 0;) {
        sum = (sum << wide_int::word_bits) + value.word[i];
    }
    return sum;
}

/// Makes canonical values below 2^bits_max(n): random, at or next to a power of two, or the ends of
/// the range.
template <std::size_t n>
WideInt<n> some_number(std::mt19937_64& random) {
    constexpr std::int64_t last = std::int64_t{1} << (wide_int::word_bits - 2);
    WideInt<n> value;
    const std::uint64_t kind = random() % 4;
    for (std::int64_t& word : value.word) {
        word = kind == 0   ? static_cast<std::int64_t>(random()) & wide_int::word_mask
               : kind == 1 ? 0
               : kind == 2 ? wide_int::word_mask
                           : static_cast<std::int64_t>(random() % 3);
    }
    std::int64_t& top = value.word[n - 1];
    top = kind == 2 ? last - 1 : top % last;
    if (random() % 2 == 0) {
        top = kind == 2 ? -last : -top;
    }
    return value;
}

template <std::size_t n>
std::array<Unlimited, 3> unlimited(const WideVec<n>& v) {
    return {unlimited(v[0]), unlimited(v[1]), unlimited(v[2])};
}

template <std::size_t n>
void check(std::mt19937_64& random) {
    const auto some_vec = [&] {
        return WideVec<n>{some_number<n>(random), some_number<n>(random), some_number<n>(random)};
    };
    for (int round = 0; round < 400; ++round) {
        const WideVec<n> l = wide_int::difference(some_vec(), some_vec());
        const WideVec<n> r = wide_int::difference(some_vec(), some_vec());
        const WideVec<n> s = wide_int::difference(some_vec(), some_vec());
        const auto x = unlimited(l);
        const auto y = unlimited(r);
        const auto z = unlimited(s);
        const auto normal = wide_int::cross(l, r);
        const std::array<Unlimited, 3> expected{
            x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
        ASSERT_EQ(unlimited(normal), expected) << n << ", round " << round;
        const Unlimited volume = expected[0] * z[0] + expected[1] * z[1] + expected[2] * z[2];
        const auto product = wide_int::dot(normal, s);
        ASSERT_EQ(unlimited(product), volume) << n << ", round " << round;
        ASSERT_EQ(wide_int::sign(product), volume.sign()) << n << ", round " << round;
    }
}

} // namespace

TEST(WideInt, ComputesWhatUnlimitedIntegersDo) {
    std::mt19937_64 random(3);
    check<1>(random);
    check<2>(random);
    check<3>(random);
    check<5>(random);
    check<8>(random);
    check<16>(random);
}

TEST(WideInt, ProductsOfTheLargestNumbersFit) {
    // Differences of the largest and least numbers, in the pattern that maximises a determinant.
    WideInt<4> largest;
    largest.word.fill(wide_int::word_mask);
    largest.word[3] = (std::int64_t{1} << 58) - 1;
    WideInt<4> least;
    least.word[3] = -(std::int64_t{1} << 58);
    const WideInt<4> up = wide_int::difference(largest, least);
    const WideInt<4> down = wide_int::difference(least, largest);
    const WideVec<4> l{up, up, down};
    const WideVec<4> r{down, up, up};
    const WideVec<4> s{up, down, up};

    const Unlimited e = unlimited(up);
    const auto volume = wide_int::dot(wide_int::cross(l, r), s);

    EXPECT_EQ(unlimited(volume), 4 * e * e * e);
    EXPECT_EQ(wide_int::sign(volume), 1);
}

TEST(WideInt, ASignIsThatOfAllWords) {
    WideInt<3> value;
    EXPECT_EQ(wide_int::sign(value), 0);
    value.word[0] = 1;
    EXPECT_EQ(wide_int::sign(value), 1);
    value.word[2] = -1;
    EXPECT_EQ(wide_int::sign(value), -1);
}

} // namespace cd::tests
