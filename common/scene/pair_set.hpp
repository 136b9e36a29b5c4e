// A set of pairs of bodies, such as the pairs that a job's rules ignore.
#pragma once

#include "common/scene/box_sweep.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// A set of pairs of different bodies, without order: (a, b) is (b, a). Memory: a bit for each
/// ordered pair, 32 MiB for 16,384 bodies. Questions about bodies that are in no pair look at no
/// bits.
class PairSet {
  public:
    /// Makes an empty set of pairs of the bodies 0 to `bodies` - 1.
    explicit PairSet(std::size_t bodies);

    [[nodiscard]] std::size_t bodies() const { return bodies_; }
    [[nodiscard]] bool has(BodyPair pair) const;
    /// Returns the number of pairs in the set.
    [[nodiscard]] std::uint64_t count() const;
    /// Returns the number of pairs in the set whose bodies are both in `bodies`, which has each
    /// once. The time is that of reading the rows of these bodies or of all others, whichever are
    /// fewer.
    [[nodiscard]] std::uint64_t count_among(std::span<const std::uint32_t> bodies) const;

    /// Adds all pairs of a body in `left` with another in `right`. Returns how many are new.
    std::uint64_t add(std::span<const std::uint32_t> left, std::span<const std::uint32_t> right);
    /// Adds the pairs of `add` that `except`, a set of equally many bodies, does not have. Returns
    /// how many are new.
    std::uint64_t add_except(std::span<const std::uint32_t> left,
                             std::span<const std::uint32_t> right,
                             const PairSet& except);
    /// Removes a pair, which need not be in the set.
    void remove(BodyPair pair);

    /// Returns the bits of all rows: whether the pair (row, column) is in the set. A row of each
    /// body begins with a new word.
    [[nodiscard]] std::span<const std::uint64_t> words() const { return bits_; }

  private:
    using Words = std::vector<std::uint64_t>;

    [[nodiscard]] Words bits_of(std::span<const std::uint32_t> bodies) const;
    [[nodiscard]] const std::uint64_t* row(std::uint32_t body) const;
    [[nodiscard]] std::vector<std::uint32_t> all_but(std::span<const std::uint32_t> bodies) const;
    [[nodiscard]] std::uint64_t ends_at(std::span<const std::uint32_t> bodies) const;
    [[nodiscard]] std::uint64_t ends_among(std::span<const std::uint32_t> bodies) const;
    std::uint64_t
    add_to_rows(std::span<const std::uint32_t> rows, const Words& columns, const PairSet* except);
    std::uint64_t add_pairs(std::span<const std::uint32_t> left,
                            std::span<const std::uint32_t> right,
                            const PairSet* except);

    std::size_t bodies_;
    std::size_t row_words_;
    Words bits_; ///< A row of `row_words_` for each body. The matrix is symmetric.
    std::vector<std::uint32_t> partners_; ///< Number of bits in each row.
};

} // namespace cd
