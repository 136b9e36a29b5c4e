// Decides pairs from the proven signs of their determinants, bit-parallel: one bit per pair.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cd {

/// The fifteen determinants of a pair: the sides of A's and B's corners, and, as Across(3 i + j),
/// edge i of A against edge j of B. The kernel computes those named `Opposite` with reversed sign.
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

/// The proven signs of up to 64 pairs, one bit per pair and determinant. Each byte of a row holds
/// as many pairs as a SIMD vector of floats has lanes, but at most eight.
struct SignBits {
    using Row = std::uint8_t[8];
    Row positive[pair_sign_count]{}; ///< Indexed by PairSign.
    Row negative[pair_sign_count]{};
    Row usable{}; ///< Nothing is proven for pairs without this bit.
};

/// Writes the FloatVerdicts of `count` pairs; each byte of a row holds `byte_pairs` pairs.
void decide_in_floats(const SignBits& bits,
                      std::size_t count,
                      std::size_t byte_pairs,
                      std::uint8_t* verdicts);

} // namespace cd
