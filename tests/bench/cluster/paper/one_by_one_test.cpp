#include "bench/cluster/paper/one_by_one.hpp"

#include <gtest/gtest.h>

namespace cd::bench {

namespace {

using Indices = std::vector<std::size_t>;

TEST(OneByOne, AnEmptyClientTakesWhatIsLikeItsFirstScenario) {
    const std::vector<Candidate> candidates{
        {0, {{1, 10}, {2, 5}}}, {0, {{3, 90}}}, {0, {{2, 5}, {4, 1}}}, {0, {{4, 1}}}};
    // The third shares a block with the first, the fourth one with the third.
    EXPECT_EQ(choose_one_by_one(candidates, 2, Likeness::Most), (Indices{0, 2}));
    EXPECT_EQ(choose_one_by_one(candidates, 3, Likeness::Most), (Indices{0, 2, 3}));
    EXPECT_EQ(choose_one_by_one(candidates, 2, Likeness::Least), (Indices{0, 1}));
    EXPECT_EQ(choose_one_by_one(candidates, 3, Likeness::Least), (Indices{0, 1, 3}));
}

TEST(OneByOne, ABlockThatTwoNeedCountsOnce) {
    const std::vector<Candidate> candidates{{9, {{1, 4}}}, {8, {{1, 4}}}, {3, {{1, 4}}}, {10, {}}};
    EXPECT_EQ(choose_one_by_one(candidates, 2, Likeness::Most), (Indices{0, 3}));
    // After the first, the second has 12 triangles and the third 7.
    EXPECT_EQ(choose_one_by_one(candidates, 3, Likeness::Most), (Indices{0, 1, 3}));
}

TEST(OneByOne, TakesAllIfFewWait) {
    const std::vector<Candidate> candidates{{1, {}}, {2, {}}};
    EXPECT_EQ(choose_one_by_one(candidates, 5, Likeness::Most), (Indices{0, 1}));
    EXPECT_TRUE(choose_one_by_one({}, 5, Likeness::Most).empty());
}

} // namespace

} // namespace cd::bench
