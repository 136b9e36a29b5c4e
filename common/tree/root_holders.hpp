// Records which workers hold which distribution roots of one tree: the indicators of all workers
// (paper, 6.4.5), indexed by root.
#pragma once

#include "common/tree/cut.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// A root that a scenario touches, with the value of holding it (its triangles or its bytes).
struct WeightedRoot {
    RootIndex root = 0;
    std::uint32_t weight = 0;
};

/// A bit matrix of roots and holders. Holders are small numbers, so that a root's row of bits is
/// short, and the cost of a sum depends only on the roots that a scenario touches.
class RootHolders {
  public:
    RootHolders(std::uint32_t root_count, std::uint32_t holder_count);

    [[nodiscard]] std::uint32_t root_count() const { return root_count_; }
    [[nodiscard]] std::uint32_t holder_count() const { return holder_count_; }
    /// Adds holders that hold nothing, up to `holder_count`, which is at least the current count.
    void grow(std::uint32_t holder_count);

    // ---- The root and the holder must exist --------------------------------------------------
    [[nodiscard]] bool holds(std::uint32_t holder, RootIndex root) const;
    /// Records that the holder holds the root. Returns false if that was recorded already.
    bool set(std::uint32_t holder, RootIndex root);
    /// Records that the holder lacks the root. Returns false if that was recorded already.
    bool clear(std::uint32_t holder, RootIndex root);
    void clear_all(std::uint32_t holder);
    /// Returns the number of holders of `root`.
    [[nodiscard]] std::uint32_t holders_of(RootIndex root) const { return counts_[root]; }
    /// Returns the number of roots that `holder` holds.
    [[nodiscard]] std::uint32_t roots_of(std::uint32_t holder) const { return roots_[holder]; }
    /// Returns whether any holder holds any root.
    [[nodiscard]] bool any() const { return set_count_ != 0; }

    /// Returns the length of the sums of `add_held`. It depends only on the number of holders and
    /// is at least that number.
    [[nodiscard]] std::size_t sum_count() const { return 64 * row_words_; }
    /// Adds to each holder's sum the weights of the elements of `roots` that the holder holds.
    void add_held(std::span<const WeightedRoot> roots, std::span<std::uint64_t> sums) const;
    /// Returns the sum of the weights of the elements of `roots` that `holder` holds.
    [[nodiscard]] std::uint64_t held(std::uint32_t holder,
                                     std::span<const WeightedRoot> roots) const;

  private:
    [[nodiscard]] std::size_t word_of(std::uint32_t holder, RootIndex root) const {
        return std::size_t{root} * row_words_ + holder / 64;
    }

    std::uint32_t root_count_ = 0;
    std::uint32_t holder_count_ = 0;
    std::size_t row_words_ = 0;
    std::vector<std::uint64_t> bits_;   ///< Row by row; holder h is bit h % 64 of word h / 64.
    std::vector<std::uint32_t> counts_; ///< Number of holders of each root.
    std::vector<std::uint32_t> roots_;  ///< Number of roots that each holder holds.
    std::uint64_t set_count_ = 0;       ///< Number of set bits.
};

} // namespace cd
