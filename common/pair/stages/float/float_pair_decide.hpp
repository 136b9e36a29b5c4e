// What the proven signs of a pair's determinants say of it, a bit for each of many pairs.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cd {

/// The determinants of a pair, in the order of double_triangle_pair.hpp; some are written with the
/// opposite sign.
enum class PairSign : std::size_t {
    ASide0,
    ASide1,
    ASide2,
    BSide0Opposite,
    BSide1,
    BSide2,
    Across0,
    Across1,
    Across2Opposite,
    Across3,
    Across4,
    Across5,
    Across6Opposite,
    Across7,
    Across8,
};
inline constexpr std::size_t pair_sign_count = 15;

/// For each of up to 64 pairs a bit: is a determinant proven positive, or negative? Each byte holds
/// as many pairs as a vector, but eight at most.
struct SignBits {
    using Row = std::uint8_t[8];
    Row positive[pair_sign_count]{}; ///< By PairSign.
    Row negative[pair_sign_count]{};
    Row usable{}; ///< Otherwise nothing is proven.
};

/// Writes the FloatVerdicts of `count` pairs, of which each byte of a row holds `byte_pairs`.
void decide_in_floats(const SignBits& bits,
                      std::size_t count,
                      std::size_t byte_pairs,
                      std::uint8_t* verdicts);

} // namespace cd
