// Compares sorted boxes with one another, with SIMD.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cd {

/// Columns of boxes that are sorted by their low ends on axis 0. Behind the last box, each column
/// has `sweep_padding` more places; those of `low[0]` are NaN.
struct SweepColumns {
    std::array<const float*, 3> low;
    std::array<const float*, 3> high;
    const std::uint32_t* body; ///< Numbers below 2^16.
    std::uint32_t count;       ///< At most 2^16.
};

inline constexpr std::size_t sweep_padding = 16;

/// Which of the other boxes a box is compared with, if they begin before it ends.
enum class SweepFrom : std::uint8_t {
    Next,  ///< Those after its own place; the others are the boxes themselves.
    Equal, ///< Those that begin where it begins, or after.
    After, ///< Those that begin after it begins.
};

/// The next box to compare.
struct SweepPlace {
    std::uint32_t row = 0;
    std::uint32_t first = 0; ///< No earlier one of the others can begin late enough.
};

/// Writes the pairs of boxes that overlap, one of `rows` from `place` on and one of `others`, as
/// numbers that sort as the pairs do: the lesser body in the high 16 bits. Ends after the last row,
/// or where `keys` may not have room for another row, which is `others.count + sweep_padding`
/// numbers. Moves `place` on. Returns how many numbers it wrote. `blocks` has room for as many
/// numbers as a row.
[[nodiscard]] std::size_t write_overlaps(const SweepColumns& rows,
                                         const SweepColumns& others,
                                         SweepFrom from,
                                         SweepPlace& place,
                                         std::span<std::uint32_t> blocks,
                                         std::span<std::uint32_t> keys);

} // namespace cd
