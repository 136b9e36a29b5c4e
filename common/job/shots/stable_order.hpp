// Orders items by small numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Sorts by keys of 32 bits in time that is linear in their count. For some thousand keys, whose
/// high bits are mostly equal, this is several times as fast as a sort by comparison. Keeps its
/// memory.
class StableOrder {
  public:
    /// Returns the indices of the keys in ascending order of these; indices of equal keys ascend.
    /// Valid until the next call.
    [[nodiscard]] std::span<const std::uint32_t> of(std::span<const std::uint32_t> keys);

  private:
    static constexpr unsigned digit_bits = 11;
    static constexpr std::uint32_t digits = 1u << digit_bits;

    void sort_by_digit(std::span<const std::uint32_t> keys, unsigned shift);

    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> next_;
    std::array<std::uint32_t, digits> begins_{};
};

} // namespace cd
