// Proves that numbers are sorted.
#include "common/geometry/number_sorter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace cd::tests {

namespace {

template <class Number>
void expect_sorts() {
    std::mt19937_64 random(1);
    const NumberSorter sorter;
    for (std::size_t size = 0; size < 3000; size += 1 + size / 7) {
        std::vector<Number> numbers(size);
        for (Number& number : numbers) {
            number = static_cast<Number>(random() >> random() % 64);
        }
        std::vector<Number> expected = numbers;
        std::sort(expected.begin(), expected.end());
        sorter.sort(numbers);
        EXPECT_EQ(numbers, expected);
    }
}

} // namespace

TEST(NumberSorter, SortsAnyNumbers) {
    expect_sorts<std::uint32_t>();
    expect_sorts<std::uint64_t>();
}

} // namespace cd::tests
