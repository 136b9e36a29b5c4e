// Finds equal depths among the hits of a line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// A hash table of hits, by line and depth. Keeps its memory.
class EqualDepths {
  public:
    static constexpr std::uint32_t none = 0xffffffff;

    /// Starts over with the lines and depths of all hits, which live until the last `add`. At most
    /// `added_most` are added, and none with the depth NaN.
    void restart(std::span<const std::uint32_t> lines,
                 std::span<const double> depths,
                 std::size_t added_most);

    /// Adds a hit, by its index. Returns another one of the line that has been added and has the
    /// same depth, and keeps that one alone; else none.
    [[nodiscard]] std::uint32_t add(std::uint32_t hit);

  private:
    std::span<const std::uint32_t> lines_;
    std::span<const double> depths_;
    std::vector<std::uint32_t> table_; ///< Indices of hits; its size is a power of two.
    unsigned shift_ = 0;               ///< Leaves as many bits of a hash as the table needs.
};

} // namespace cd
