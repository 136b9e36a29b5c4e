#include "common/job/shots/stable_order.hpp"

#include <algorithm>
#include <numeric>

namespace cd {

namespace {

/// Below this count, a pass over all digits costs more than a sort by comparison.
constexpr std::size_t few_keys = 256;

} // namespace

/// Sorts by one digit after the other, the lowest first; digits that are 0 in all keys need no
/// pass.
std::span<const std::uint32_t> StableOrder::of(std::span<const std::uint32_t> keys) {
    order_.resize(keys.size());
    std::iota(order_.begin(), order_.end(), 0u);
    if (keys.size() < few_keys) {
        std::ranges::stable_sort(order_, {}, [&](std::uint32_t index) { return keys[index]; });
        return order_;
    }
    const std::uint32_t most = *std::ranges::max_element(keys);
    for (unsigned shift = 0; shift < 32 && most >> shift != 0; shift += digit_bits) {
        sort_by_digit(keys, shift);
    }
    return order_;
}

void StableOrder::sort_by_digit(std::span<const std::uint32_t> keys, unsigned shift) {
    const auto digit = [&](std::uint32_t index) { return keys[index] >> shift & (digits - 1); };
    begins_.fill(0);
    for (const std::uint32_t key : keys) {
        ++begins_[key >> shift & (digits - 1)];
    }
    std::exclusive_scan(begins_.begin(), begins_.end(), begins_.begin(), 0u);
    next_.resize(order_.size());
    for (const std::uint32_t index : order_) {
        next_[begins_[digit(index)]++] = index;
    }
    order_.swap(next_);
}

} // namespace cd
