#include "common/pair/stages/float/float_pair_decide.hpp"

#include <bit>
#include <cstring>

namespace cd {

namespace {

/// One bit for each of 64 pairs.
using Word = std::uint64_t;

Word word_of(const SignBits::Row& row) {
    static_assert(std::endian::native == std::endian::little);
    return std::bit_cast<Word>(row);
}

/// A sign of 64 pairs: the pairs in which the sign is proven positive, or negative.
struct Sign {
    Word positive;
    Word negative;
};

Sign sign_of(const SignBits& bits, PairSign sign) {
    const auto row = static_cast<std::size_t>(sign);
    return {word_of(bits.positive[row]), word_of(bits.negative[row])};
}

Sign opposite(const Sign& s) {
    return {s.negative, s.positive};
}

/// Collects the pairs for which the edges judged so far prove something.
struct Proofs {
    Word all_miss = ~Word{0}; ///< No edge so far meets the other triangle.
    Word any_pierces = 0;     ///< An edge properly passes through the other triangle.
};

/// Judges an edge: `from` and `to` are the sides of the edge's ends, x, y and z the edge's sides
/// against the other triangle's edges.
void judge_edge(
    const Sign& from, const Sign& to, const Sign& x, const Sign& y, const Sign& z, Proofs& proofs) {
    const Word one_sided = (from.positive & to.positive) | (from.negative & to.negative);
    const Word crosses = (from.positive & to.negative) | (from.negative & to.positive);
    const Word passes =
        (x.positive | y.positive | z.positive) & (x.negative | y.negative | z.negative);
    const Word encircled =
        (x.positive & y.positive & z.positive) | (x.negative & y.negative & z.negative);
    proofs.all_miss &= one_sided | passes;
    proofs.any_pierces |= crosses & encircled;
}

Word all_agree(const Sign& x, const Sign& y, const Sign& z) {
    return (x.positive & y.positive & z.positive) | (x.negative & y.negative & z.negative);
}

Word any_proven(const Sign& x, const Sign& y, const Sign& z) {
    return x.positive | x.negative | y.positive | y.negative | z.positive | z.negative;
}

struct Verdicts {
    Word separate;
    Word proper;
};

/// Decides 64 pairs from their proven signs.
Verdicts decide(const SignBits& bits) {
    const Sign a0 = sign_of(bits, PairSign::ASide0);
    const Sign a1 = sign_of(bits, PairSign::ASide1);
    const Sign a2 = sign_of(bits, PairSign::ASide2);
    const Sign b0 = opposite(sign_of(bits, PairSign::BSide0Opposite));
    const Sign b1 = sign_of(bits, PairSign::BSide1);
    const Sign b2 = sign_of(bits, PairSign::BSide2);
    const Sign o[9] = {sign_of(bits, PairSign::Across0),
                       sign_of(bits, PairSign::Across1),
                       opposite(sign_of(bits, PairSign::Across2Opposite)),
                       sign_of(bits, PairSign::Across3),
                       sign_of(bits, PairSign::Across4),
                       sign_of(bits, PairSign::Across5),
                       opposite(sign_of(bits, PairSign::Across6Opposite)),
                       sign_of(bits, PairSign::Across7),
                       sign_of(bits, PairSign::Across8)};
    Proofs proofs;
    judge_edge(a0, a1, o[0], o[1], o[2], proofs);
    judge_edge(a1, a2, o[3], o[4], o[5], proofs);
    judge_edge(a2, a0, o[6], o[7], o[8], proofs);
    judge_edge(b0, b1, o[0], o[3], o[6], proofs);
    judge_edge(b1, b2, o[1], o[4], o[7], proofs);
    judge_edge(b2, b0, o[2], o[5], o[8], proofs);
    const Word usable = word_of(bits.usable);
    const Word separate = proofs.all_miss | all_agree(a0, a1, a2) | all_agree(b0, b1, b2);
    const Word proper = proofs.any_pierces & any_proven(a0, a1, a2) & any_proven(b0, b1, b2);
    return {separate & usable, proper & usable};
}

/// Expands the low eight bits to eight bytes of 0 or 1, lowest first.
Word bytes_of(Word bits) {
    const Word apart = (bits & 0xff) * 0x0101010101010101u & 0x8040201008040201u;
    return (apart + 0x7f7f7f7f7f7f7f7fu) >> 7 & 0x0101010101010101u;
}

} // namespace

void decide_in_floats(const SignBits& bits,
                      std::size_t count,
                      std::size_t byte_pairs,
                      std::uint8_t* verdicts) {
    const Verdicts all = decide(bits);
    // If a byte holds fewer than eight pairs, the verdicts of the next byte overwrite the surplus.
    std::uint8_t found[64 + sizeof(Word)];
    for (std::size_t i = 0; i < sizeof(Word); ++i) {
        const Word eight = bytes_of(all.separate >> 8 * i) + 2 * bytes_of(all.proper >> 8 * i);
        std::memcpy(found + i * byte_pairs, &eight, sizeof(eight));
    }
    std::memcpy(verdicts, found, count);
}

} // namespace cd
