// Who holds which distribution roots of one tree: the indicators of all workers (paper, 6.4.5),
// indexed by root.
#pragma once

#include "common/tree/cut.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// A root that a scenario touches, with what holding it is worth (its triangles, its bytes).
struct WeightedRoot {
    RootIndex root = 0;
    std::uint32_t weight = 0;
};

/// A bit for each pair of a root and a holder. Holders are small numbers, so that a root's row of
/// bits is short, and adding up over the roots that a scenario touches costs what it touches.
class RootHolders {
  public:
    RootHolders(std::uint32_t root_count, std::uint32_t holder_count);

    [[nodiscard]] std::uint32_t root_count() const { return root_count_; }
    [[nodiscard]] std::uint32_t holder_count() const { return holder_count_; }
    /// The new ones hold nothing. Never fewer than now.
    void grow(std::uint32_t holder_count);

    // ---- The root and the holder exist -------------------------------------------------------
    [[nodiscard]] bool holds(std::uint32_t holder, RootIndex root) const;
    /// False where that was so already.
    bool set(std::uint32_t holder, RootIndex root);
    bool clear(std::uint32_t holder, RootIndex root);
    void clear_all(std::uint32_t holder);
    /// How many hold it.
    [[nodiscard]] std::uint32_t holders_of(RootIndex root) const { return counts_[root]; }
    /// How many it holds.
    [[nodiscard]] std::uint32_t roots_of(std::uint32_t holder) const { return roots_[holder]; }
    /// Somebody holds something.
    [[nodiscard]] bool any() const { return set_count_ != 0; }

    /// How many sums `add_held` adds to: the holders, up to a multiple of 64.
    [[nodiscard]] std::size_t sum_count() const { return 64 * row_words_; }
    /// Adds to each holder's sum the weights of those roots that it holds.
    void add_held(std::span<const WeightedRoot> roots, std::span<std::uint64_t> sums) const;
    /// The same for one holder.
    [[nodiscard]] std::uint64_t held(std::uint32_t holder,
                                     std::span<const WeightedRoot> roots) const;

  private:
    [[nodiscard]] std::size_t word_of(std::uint32_t holder, RootIndex root) const {
        return std::size_t{root} * row_words_ + holder / 64;
    }

    std::uint32_t root_count_ = 0;
    std::uint32_t holder_count_ = 0;
    std::size_t row_words_ = 0;
    std::vector<std::uint64_t> bits_; ///< Row by row; holder h is bit h % 64 of word h / 64.
    std::vector<std::uint32_t> counts_;
    std::vector<std::uint32_t> roots_; ///< Of each holder.
    std::uint64_t set_count_ = 0;
};

} // namespace cd
