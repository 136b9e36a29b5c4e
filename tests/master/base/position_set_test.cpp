// Proves that a set of positions keeps its runs maximal, and agrees with a plain set.
#include "master/base/position_set.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace cd::tests {
namespace {

using List = std::vector<std::uint64_t>;
using Runs = std::vector<PositionRange>;

Runs runs_of(const PositionSet& set) {
    return {set.runs().begin(), set.runs().end()};
}

TEST(PositionSet, RunsThatTouchAreJoined) {
    PositionSet set;
    set.add({5, 2});
    set.add({9, 1});
    set.add({7, 2});
    set.add({3, 0});
    EXPECT_EQ(runs_of(set), (Runs{{5, 5}}));
    EXPECT_EQ(set.count(), 5u);
    EXPECT_EQ(runs_of(PositionSet::of({7, 3, 4, 5, 9, 10})), (Runs{{3, 3}, {7, 1}, {9, 2}}));
    EXPECT_TRUE(PositionSet::of({}).is_empty());
}

TEST(PositionSet, AHoleSplitsARun) {
    PositionSet set(PositionRange{0, 10});
    set.remove({4, 2});
    set.remove({20, 5});
    EXPECT_EQ(runs_of(set), (Runs{{0, 4}, {6, 4}}));
    EXPECT_TRUE(set.contains(3) && !set.contains(4) && !set.contains(5) && set.contains(6));
    set.remove(PositionRange{2, 6});
    EXPECT_EQ(set.list(), (List{0, 1, 8, 9}));
    set.remove(PositionSet(PositionRange{0, 10}));
    EXPECT_TRUE(set.is_empty());
}

TEST(PositionSet, TheLastPositionsMaySpanRuns) {
    const PositionSet set = PositionSet::of({1, 2, 3, 7, 8});
    EXPECT_EQ(set.last(3).list(), (List{3, 7, 8}));
    EXPECT_EQ(set.last(9), set);
    EXPECT_TRUE(set.last(0).is_empty());
}

TEST(PositionSet, AgreesWithAPlainSet) {
    std::mt19937_64 random(3);
    const auto range = [&] { return PositionRange{random() % 60, random() % 12}; };
    const auto apply = [&](PositionSet& set, std::set<std::uint64_t>& plain) {
        const PositionRange some = range();
        const bool adds = random() % 2 == 0;
        adds ? set.add(some) : set.remove(some);
        for (std::uint64_t position = some.first; position < some.end(); ++position) {
            adds ? void(plain.insert(position)) : void(plain.erase(position));
        }
    };
    PositionSet one;
    PositionSet other;
    std::set<std::uint64_t> plain_one;
    std::set<std::uint64_t> plain_other;
    for (int step = 0; step < 2000; ++step) {
        apply(one, plain_one);
        apply(other, plain_other);
        ASSERT_EQ(one.list(), List(plain_one.begin(), plain_one.end()));
        ASSERT_EQ(one.count(), plain_one.size());
        ASSERT_EQ(one, PositionSet::of(one.list())) << "the runs are maximal";
        List both;
        std::ranges::set_intersection(plain_one, plain_other, std::back_inserter(both));
        ASSERT_EQ(one.common_with(other).list(), both);
        PositionSet sum = one;
        sum.add(other);
        PositionSet rest = sum;
        rest.remove(other);
        ASSERT_EQ(sum.count(), plain_one.size() + plain_other.size() - both.size());
        ASSERT_EQ(rest.count(), plain_one.size() - both.size());
    }
}

} // namespace
} // namespace cd::tests
