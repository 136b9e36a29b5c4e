#include "common/scene/pair_set.hpp"

#include "common/core/check.hpp"

#include <bit>
#include <numeric>

namespace cd {

namespace {

constexpr std::size_t word_bits = 64;

std::uint64_t bit_of(std::uint32_t body) {
    return std::uint64_t{1} << (body % word_bits);
}

} // namespace

PairSet::PairSet(std::size_t bodies)
    : bodies_(bodies),
      row_words_((bodies + word_bits - 1) / word_bits),
      bits_(bodies * row_words_, 0),
      partners_(bodies, 0) {}

const std::uint64_t* PairSet::row(std::uint32_t body) const {
    CD_CHECK(body < bodies_);
    return bits_.data() + body * row_words_;
}

bool PairSet::has(BodyPair pair) const {
    CD_CHECK(pair.a < bodies_);
    CD_CHECK(pair.b < bodies_);
    return partners_[pair.a] != 0 && (row(pair.a)[pair.b / word_bits] & bit_of(pair.b)) != 0;
}

std::uint64_t PairSet::count() const {
    return std::accumulate(partners_.begin(), partners_.end(), std::uint64_t{0}) / 2;
}

std::uint64_t PairSet::count_among(std::span<const std::uint32_t> bodies) const {
    if (bodies.size() <= bodies_ / 2) {
        return ends_among(bodies) / 2;
    }
    // Subtracts each pair that has one of the other bodies. A pair of two other bodies is
    // subtracted twice, so it is added back once.
    const std::vector<std::uint32_t> others = all_but(bodies);
    return count() + ends_among(others) / 2 - ends_at(others);
}

std::vector<std::uint32_t> PairSet::all_but(std::span<const std::uint32_t> bodies) const {
    const Words taken = bits_of(bodies);
    std::vector<std::uint32_t> others;
    for (std::uint32_t body = 0; body < bodies_; ++body) {
        if ((taken[body / word_bits] & bit_of(body)) == 0) {
            others.push_back(body);
        }
    }
    return others;
}

/// Counts, for each body, the pairs that have it.
std::uint64_t PairSet::ends_at(std::span<const std::uint32_t> bodies) const {
    std::uint64_t ends = 0;
    for (const std::uint32_t body : bodies) {
        ends += partners_[body];
    }
    return ends;
}

/// Counts, for each body, the pairs of it and another of the bodies.
std::uint64_t PairSet::ends_among(std::span<const std::uint32_t> bodies) const {
    const Words columns = bits_of(bodies);
    std::uint64_t ends = 0;
    for (const std::uint32_t body : bodies) {
        const std::uint64_t* const words = row(body);
        for (std::size_t i = 0; i < row_words_ && partners_[body] != 0; ++i) {
            ends += static_cast<std::uint64_t>(std::popcount(words[i] & columns[i]));
        }
    }
    return ends;
}

std::uint64_t PairSet::add(std::span<const std::uint32_t> left,
                           std::span<const std::uint32_t> right) {
    return add_pairs(left, right, nullptr);
}

std::uint64_t PairSet::add_except(std::span<const std::uint32_t> left,
                                  std::span<const std::uint32_t> right,
                                  const PairSet& except) {
    CD_CHECK(except.bodies_ == bodies_);
    return add_pairs(left, right, &except);
}

void PairSet::remove(BodyPair pair) {
    if (!has(pair)) {
        return;
    }
    --partners_[pair.a];
    --partners_[pair.b];
    bits_[pair.a * row_words_ + pair.b / word_bits] &= ~bit_of(pair.b);
    bits_[pair.b * row_words_ + pair.a / word_bits] &= ~bit_of(pair.a);
}

std::uint64_t PairSet::add_pairs(std::span<const std::uint32_t> left,
                                 std::span<const std::uint32_t> right,
                                 const PairSet* except) {
    // Each new pair sets two bits, one in the row of each body.
    const std::uint64_t of_left = add_to_rows(left, bits_of(right), except);
    return (of_left + add_to_rows(right, bits_of(left), except)) / 2;
}

/// Sets the bits of `columns` in the rows, except those on the diagonal and those of `except`.
/// Returns how many are new.
std::uint64_t PairSet::add_to_rows(std::span<const std::uint32_t> rows,
                                   const Words& columns,
                                   const PairSet* except) {
    std::uint64_t added = 0;
    for (const std::uint32_t body : rows) {
        CD_CHECK(body < bodies_);
        std::uint64_t* const words = bits_.data() + body * row_words_;
        for (std::size_t i = 0; i < row_words_; ++i) {
            std::uint64_t wanted = columns[i] & ~words[i];
            wanted &= i == body / word_bits ? ~bit_of(body) : ~std::uint64_t{0};
            wanted &= except != nullptr ? ~except->row(body)[i] : ~std::uint64_t{0};
            words[i] |= wanted;
            partners_[body] += static_cast<std::uint32_t>(std::popcount(wanted));
            added += static_cast<std::uint64_t>(std::popcount(wanted));
        }
    }
    return added;
}

PairSet::Words PairSet::bits_of(std::span<const std::uint32_t> bodies) const {
    Words words(row_words_, 0);
    for (const std::uint32_t body : bodies) {
        CD_CHECK(body < bodies_);
        words[body / word_bits] |= bit_of(body);
    }
    return words;
}

} // namespace cd
