// Proves that mistyped words get the right suggestion, and that numbers are formatted readably.
#include "common/core/words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace cd::tests {

namespace {

constexpr std::array<std::string_view, 4> known{"level", "limit_pairs", "maps", "ignore"};

} // namespace

TEST(Words, AnEditOrTwoSwappedNeighboursFindTheWord) {
    EXPECT_EQ(nearest_word("levle", known), "level");
    EXPECT_EQ(nearest_word("limit_pair", known), "limit_pairs");
    constexpr std::array<std::string_view, 3> verbs{"run", "watch", "inspect"};
    EXPECT_EQ(nearest_word("rnu", verbs), "run");
    EXPECT_EQ(nearest_word("nur", verbs), std::nullopt);
}

TEST(Words, SomethingElseFindsNothing) {
    EXPECT_EQ(nearest_word("colour", known), std::nullopt);
    EXPECT_EQ(nearest_word(std::string(100'000, 'l'), known), std::nullopt);
    EXPECT_EQ(suggestion("colour", known), "; known are level, limit_pairs, maps, ignore");
    const std::vector<std::string_view> many(30, "x1");
    const std::string listed = suggestion("colour", many);
    EXPECT_EQ(std::ranges::count(listed, 'x'), 20);
    EXPECT_TRUE(listed.ends_with("x1, ..."));
}

TEST(Words, NumbersAreGroupedByThrees) {
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1000), "1 000");
    EXPECT_EQ(grouped(1234567), "1 234 567");
    EXPECT_EQ(counted(1, "part"), "1 part");
    EXPECT_EQ(counted(12, "part"), "12 parts");
}

TEST(Words, ExactTextReadsBackAsTheSameDouble) {
    for (const double value : {0.1, 1.0 / 3, -1e-300, 12345678.9}) {
        EXPECT_EQ(std::stod(exact_text(value)), value);
    }
}

} // namespace cd::tests
