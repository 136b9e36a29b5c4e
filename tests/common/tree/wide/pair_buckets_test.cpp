// Proves that waiting pairs are popped by rank, the last pushed of equal rank first, each once, for
// any order of operations.
#include "common/tree/wide/pair_buckets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace cd::tests {
namespace {

TEST(PairBuckets, TheMostPromisingComesFirstAndOfEqualsTheLast) {
    PairBuckets buckets;
    buckets.push({1, 1}, 40);
    buckets.push({2, 2}, 3);
    buckets.push({3, 3}, 3);
    buckets.push({4, 4}, 63);
    for (const std::uint32_t expected : {3u, 2u, 1u, 4u}) {
        EXPECT_EQ(buckets.pop().a, expected);
    }
    EXPECT_EQ(buckets.size(), 0u);
}

TEST(PairBuckets, RanksOutOfRangeCountAsTheNearest) {
    PairBuckets buckets;
    buckets.push({1, 0}, std::numeric_limits<std::int32_t>::max());
    buckets.push({2, 0}, std::numeric_limits<std::int32_t>::min());
    buckets.push({3, 0}, 1);
    EXPECT_EQ(buckets.pop().a, 2u);
    EXPECT_EQ(buckets.pop().a, 3u);
    EXPECT_EQ(buckets.pop().a, 1u);
}

TEST(PairBuckets, EqualsAListSortedByRankAndTime) {
    struct Waiting {
        std::int32_t rank;
        std::uint32_t name;
    };
    std::mt19937_64 random(1); // NOLINT: the same numbers each time.
    PairBuckets buckets;
    for (int round = 0; round < 20; ++round) {
        buckets.clear();
        std::vector<Waiting> expected;
        for (std::uint32_t name = 0; name < 3000; ++name) {
            const auto rank = static_cast<std::int32_t>(random() % 64);
            buckets.push({name, 2 * name}, rank);
            expected.push_back({rank, name});
            if (random() % 3 == 0) {
                const auto best = std::min_element(
                    expected.rbegin(), expected.rend(), [](const Waiting& x, const Waiting& y) {
                        return x.rank < y.rank;
                    });
                const WidePair taken = buckets.pop();
                ASSERT_EQ(taken.a, best->name);
                ASSERT_EQ(taken.b, 2 * best->name);
                expected.erase(std::next(best).base());
            }
            ASSERT_EQ(buckets.size(), expected.size());
        }
    }
}

} // namespace
} // namespace cd::tests
