// Proves that numbers are sorted.
#include "common/tree/build/number_sorter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace cd::tests {

TEST(NumberSorter, SortsAnyNumbers) {
    std::mt19937_64 random(1);
    const NumberSorter sorter;
    for (std::size_t size = 0; size < 3000; size += 1 + size / 7) {
        std::vector<std::uint32_t> numbers(size);
        for (std::uint32_t& number : numbers) {
            number = static_cast<std::uint32_t>(random() >> (32 + random() % 32));
        }
        std::vector<std::uint32_t> expected = numbers;
        std::sort(expected.begin(), expected.end());
        sorter.sort(numbers);
        EXPECT_EQ(numbers, expected);
    }
}

} // namespace cd::tests
