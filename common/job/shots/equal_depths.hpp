// Finds equal depths among the hits of a line.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Stores the hits of each line in a linked list, or in a shared hash table if the line has many.
/// A 64-bit filter of the line's depths avoids most searches of its list. Reuses its memory.
class EqualDepths {
  public:
    static constexpr std::uint32_t none = 0xffffffff;

    /// Removes all hits. `lines` (each less than `line_count`) and `depths` describe the hits to be
    /// added, by index, and must live until the last `add`.
    void restart(std::span<const std::uint32_t> lines,
                 std::span<const double> depths,
                 std::size_t line_count);

    /// Adds a hit by its index. Each hit may be added once; its depth must not be NaN. If a stored
    /// hit of the line has the same depth, returns that hit and does not store the new one; else
    /// returns `none`.
    [[nodiscard]] std::uint32_t add(std::uint32_t hit) {
        Line& line = of_lines_[lines_[hit]];
        const std::uint64_t bit = std::uint64_t{1} << hash_of(depths_[hit], 6);
        if ((line.depths & bit) != 0) {
            const std::uint32_t other = find(line, hit);
            if (other != none || line.last == in_table) {
                return other;
            }
        }
        line.depths |= bit;
        before_[hit] = line.last;
        line.last = hit;
        return none;
    }

  private:
    static constexpr std::uint32_t in_table = none - 1;

    struct Line {
        std::uint64_t depths = 0;  ///< Bit mask of hashes of its depths; all ones in the table.
        std::uint32_t last = none; ///< The hit of its list added last; or `in_table`.
    };

    /// Hashes a depth to a number of `bits` bits. Fibonacci hashing (Knuth, The Art of Computer
    /// Programming, volume 3, section 6.4): the high bits of a product depend on all bits of the
    /// factor.
    [[nodiscard]] static std::size_t hash_of(double depth, unsigned bits, std::uint64_t other = 0) {
        constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;
        return (std::bit_cast<std::uint64_t>(depth) + other) * golden >> (64 - bits);
    }
    [[nodiscard]] std::uint32_t find(Line& line, std::uint32_t hit);
    void move_to_table(Line& line);
    [[nodiscard]] std::uint32_t add_to_table(std::uint32_t hit);

    std::span<const std::uint32_t> lines_;
    std::span<const double> depths_;
    std::vector<Line> of_lines_;
    std::vector<std::uint32_t> before_; ///< By hit: that before it in its line's list, or none.
    std::vector<std::uint32_t> table_;  ///< Indices of hits, if some line has many.
    unsigned table_bits_ = 0;           ///< Its size is the power of two.
};

} // namespace cd
