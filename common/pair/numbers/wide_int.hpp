// Fixed-size multiword integers on the stack, and the products that determinants consist of.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// The sum of word[i] * 2^(60 i), with signed words. A number is canonical if all words but the
/// last are in [0, 2^60). Sums and differences of canonical numbers are taken word by word, without
/// carries.
///
/// Words of 60 bits leave room for signs and sums: a column of a product, a 2 x 2 determinant or a
/// dot product sums in 128 bits without a carry, so each of these needs one pass of carries. (Full
/// words with carries everywhere are several times slower with GCC 12.) Expansions of doubles
/// (Shewchuk 1997) are many times slower: the sign of a triple product of differences takes 11, 34
/// and 78 ns in one, two and three words on an AMD EPYC. Plain zero-eliminating expansions took 600
/// ns for unposed coordinates and 1800 ns for posed ones, which need three words. Multiword
/// integers also depend on neither fused multiplication nor the doubles' exponent range. `bits_max`
/// alone defines what fits.
template <std::size_t words>
struct WideInt {
    std::array<std::int64_t, words> word{};

    friend constexpr bool operator==(const WideInt&, const WideInt&) = default;
};

template <std::size_t words>
using WideVec = std::array<WideInt<words>, 3>;

namespace wide_int {

inline constexpr int word_bits = 60;
inline constexpr std::int64_t word_mask = (std::int64_t{1} << word_bits) - 1;

/// Bounds the magnitude of canonical coordinates, so that dot(cross(d1, d2), d3) of any of their
/// differences d does not overflow, for up to 42 words: with |coordinate| below 2^bits, a last word
/// is within 2^58, and any word of a difference within 2^60. A column of the cross product sums
/// 2 * words products within 2^120, and a column of the dot product 3 * words, so both are below
/// 2^127 even with a carry. A component of the cross product is below 2 * 2^(2 bits + 2), and the
/// dot product below 6 * 2^(3 bits + 3), so their last words are within 2^59 and 2^60.
constexpr int bits_max(std::size_t words) {
    return word_bits * static_cast<int>(words) - 2;
}

__extension__ typedef __int128 Column;

/// Computes the sum of all products of words of l and r with the weight 2^(60 index).
template <std::size_t n, std::size_t m>
constexpr Column column(const WideInt<n>& l, const WideInt<m>& r, std::size_t index) {
    Column sum = 0;
    const std::size_t first = index < m ? 0 : index - m + 1;
    const std::size_t last = index < n ? index : n - 1;
#pragma GCC unroll 16
    for (std::size_t i = first; i <= last; ++i) {
        sum += Column{l.word[i]} * r.word[index - i];
    }
    return sum;
}

/// Turns columns into a canonical number by one pass of carries. `column_of(i)` returns column i,
/// for all words but the last; `last` is added to the carry into the last word.
template <std::size_t words, class ColumnOf>
constexpr WideInt<words> carried(Column last, const ColumnOf& column_of) {
    WideInt<words> value;
    Column carry = 0;
#pragma GCC unroll 32
    for (std::size_t i = 0; i + 1 < words; ++i) {
        carry += column_of(i);
        value.word[i] = static_cast<std::int64_t>(carry) & word_mask;
        carry >>= word_bits; // C++20 guarantees rounding down.
    }
    value.word[words - 1] = static_cast<std::int64_t>(carry + last);
    return value;
}

/// Returns the sign of a canonical number: -1, 0 or 1.
template <std::size_t words>
constexpr int sign(const WideInt<words>& canonical) {
    std::int64_t any = 0;
    for (const std::int64_t word : canonical.word) {
        any |= word;
    }
    return canonical.word[words - 1] < 0 ? -1 : static_cast<int>(any != 0);
}

template <std::size_t n>
constexpr WideInt<n> difference(const WideInt<n>& l, const WideInt<n>& r) {
    WideInt<n> d;
    for (std::size_t i = 0; i < n; ++i) {
        d.word[i] = l.word[i] - r.word[i];
    }
    return d;
}

template <std::size_t n>
constexpr WideVec<n> difference(const WideVec<n>& l, const WideVec<n>& r) {
    return {difference(l[0], r[0]), difference(l[1], r[1]), difference(l[2], r[2])};
}

/// Computes a d - b c.
template <std::size_t n>
constexpr WideInt<2 * n>
determinant(const WideInt<n>& a, const WideInt<n>& b, const WideInt<n>& c, const WideInt<n>& d) {
    return carried<2 * n>(
        0, [&](std::size_t index) { return column(a, d, index) - column(b, c, index); });
}

template <std::size_t n>
constexpr WideVec<2 * n> cross(const WideVec<n>& l, const WideVec<n>& r) {
    return {determinant(l[1], l[2], r[1], r[2]),
            determinant(l[2], l[0], r[2], r[0]),
            determinant(l[0], l[1], r[0], r[1])};
}

template <std::size_t n, std::size_t m>
constexpr WideInt<n + m> dot(const WideVec<n>& l, const WideVec<m>& r) {
    static_assert(std::min(n, m) <= 42, "see `bits_max`");
    return carried<n + m>(0, [&](std::size_t index) {
        return column(l[0], r[0], index) + column(l[1], r[1], index) + column(l[2], r[2], index);
    });
}

} // namespace wide_int

} // namespace cd
