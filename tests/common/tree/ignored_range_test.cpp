// Proves that the ignored ranges of two bodies are found among those of a job.

#include "common/tree/ignored_range.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cd::tests {

TEST(IgnoredRange, RangesOfTwoBodiesAreFound) {
    const std::vector<IgnoredRange> ignored{
        {1, 2, 3, 4, 0, 1}, {5, 6, 7, 8, 0, 1}, {1, 2, 3, 4, 0, 3}, {9, 10, 0, 1, 2, 3}};
    ASSERT_TRUE(are_in_order(ignored));
    const auto found = [&](std::uint32_t a, std::uint32_t b) {
        const auto ranges = ignored_of(ignored, a, b);
        return std::vector(ranges.begin(), ranges.end());
    };
    EXPECT_EQ(found(0, 1), (std::vector{ignored[0], ignored[1]}));
    EXPECT_EQ(found(0, 3), std::vector{ignored[2]});
    EXPECT_EQ(found(2, 3), std::vector{ignored[3]});
    EXPECT_TRUE(found(0, 2).empty());
    EXPECT_TRUE(found(1, 0).empty());
    EXPECT_TRUE(found(3, 4).empty());
}

TEST(IgnoredRange, PairsOfBodiesAscendAndAComesFirst) {
    EXPECT_TRUE(are_in_order({}));
    EXPECT_TRUE(are_in_order(std::vector<IgnoredRange>{{5, 6, 0, 1}, {0, 1, 0, 1}}));
    EXPECT_FALSE(are_in_order(std::vector<IgnoredRange>{{0, 1, 0, 1, 0, 2}, {0, 1, 0, 1, 0, 1}}));
    EXPECT_FALSE(are_in_order(std::vector<IgnoredRange>{{0, 1, 0, 1, 1, 2}, {0, 1, 0, 1, 0, 3}}));
    EXPECT_FALSE(are_in_order(std::vector<IgnoredRange>{{0, 1, 0, 1, 1, 0}}));
    EXPECT_FALSE(are_in_order(std::vector<IgnoredRange>{{0, 1, 0, 1, 1, 1}}));
}

} // namespace cd::tests
