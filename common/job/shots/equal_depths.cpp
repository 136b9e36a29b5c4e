#include "common/job/shots/equal_depths.hpp"

#include <algorithm>
#include <bit>

namespace cd {

void EqualDepths::restart(std::span<const std::uint32_t> lines,
                          std::span<const double> depths,
                          std::size_t added_most) {
    lines_ = lines;
    depths_ = depths;
    // At most half of the table is in use.
    const std::size_t size = std::bit_ceil(std::max<std::size_t>(2 * added_most, 2));
    table_.assign(size, none);
    shift_ = 64 - static_cast<unsigned>(std::countr_zero(size));
}

std::uint32_t EqualDepths::add(std::uint32_t hit) {
    // Fibonacci hashing (Knuth, The Art of Computer Programming, volume 3, section 6.4): the high
    // bits of a product depend on all bits of the factor.
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;
    const std::uint32_t line = lines_[hit];
    const double depth = depths_[hit];
    const std::uint64_t key = std::bit_cast<std::uint64_t>(depth) + line * std::rotl(golden, 32);
    std::size_t place = key * golden >> shift_;
    while (table_[place] != none) {
        const std::uint32_t other = table_[place];
        if (lines_[other] == line && depths_[other] == depth) {
            return other;
        }
        place = (place + 1) & (table_.size() - 1);
    }
    table_[place] = hit;
    return none;
}

} // namespace cd
