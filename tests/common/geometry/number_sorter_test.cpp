// Proves that numbers are sorted, whatever their number, range and order, as std::sort does it.
#include "common/geometry/number_sorter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace cd::tests {

namespace {

template <class Number>
void expect_sorted_like_the_library(std::vector<Number> numbers) {
    std::vector<Number> wanted = numbers;
    std::ranges::sort(wanted);
    const NumberSorter sorter;
    sorter.sort(numbers);
    EXPECT_EQ(numbers, wanted);
    sorter.sort(numbers); // Sorted numbers, with the scratch memory of the first call.
    EXPECT_EQ(numbers, wanted);
    std::ranges::reverse(numbers);
    sorter.sort(numbers);
    EXPECT_EQ(numbers, wanted);
}

} // namespace

TEST(NumberSorter, SortsNumbersOfAnyCountAndRange) {
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        SCOPED_TRACE(seed);
        std::mt19937_64 random(seed);
        for (const std::size_t count : {0u, 1u, 2u, 511u, 512u, 513u, 5000u, 70000u}) {
            for (const unsigned bits : {1u, 9u, 11u, 12u, 23u, 32u}) {
                const std::uint32_t offset = bits < 32 ? static_cast<std::uint32_t>(random()) : 0;
                std::vector<std::uint32_t> narrow(count);
                std::vector<std::uint64_t> wide(count);
                for (std::size_t i = 0; i < count; ++i) {
                    narrow[i] = offset ^ static_cast<std::uint32_t>(random() >> (64 - bits));
                    wide[i] = random() >> (64 - 2 * bits);
                }
                expect_sorted_like_the_library(narrow);
                expect_sorted_like_the_library(wide);
            }
        }
    }
}

} // namespace cd::tests
