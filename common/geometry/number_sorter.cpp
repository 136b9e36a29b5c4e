#include "common/geometry/number_sorter.hpp"

#include <hwy/contrib/sort/vqsort.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace cd {

namespace {

/// Fewer numbers are not worth the counters of a radix sort.
constexpr std::size_t radix_min = 512;
constexpr std::uint32_t digit_mask = (1u << 11) - 1;

/// Sorts by one digit after the other, the lowest first. A digit begins at the lowest bit that is
/// left and that not all numbers share.
void radix_sort(std::vector<std::uint32_t>& numbers, std::vector<std::uint32_t>& scratch) {
    std::uint32_t any = 0;
    std::uint32_t all = ~std::uint32_t{0};
    for (const std::uint32_t number : numbers) {
        any |= number;
        all &= number;
    }
    scratch.resize(numbers.size());
    for (std::uint32_t bits = any ^ all; bits != 0;) {
        const int shift = std::countr_zero(bits);
        bits &= ~(digit_mask << shift);
        std::array<std::uint32_t, digit_mask + 1> places{};
        for (const std::uint32_t number : numbers) {
            ++places[number >> shift & digit_mask];
        }
        std::uint32_t before = 0;
        for (std::uint32_t& place : places) {
            before += std::exchange(place, before);
        }
        for (const std::uint32_t number : numbers) {
            scratch[places[number >> shift & digit_mask]++] = number;
        }
        numbers.swap(scratch);
    }
}

} // namespace

struct NumberSorter::Scratch {
    hwy::Sorter sorter;
    std::vector<std::uint32_t> numbers;
};

NumberSorter::NumberSorter() : scratch_(std::make_unique<Scratch>()) {}
NumberSorter::~NumberSorter() = default;

void NumberSorter::sort(std::vector<std::uint32_t>& numbers) const {
    if (numbers.size() < radix_min) {
        scratch_->sorter(numbers.data(), numbers.size(), hwy::SortAscending());
        return;
    }
    radix_sort(numbers, scratch_->numbers);
}

void NumberSorter::sort(std::vector<std::uint64_t>& numbers) const {
    scratch_->sorter(numbers.data(), numbers.size(), hwy::SortAscending());
}

} // namespace cd
