// Proves that the sums over rows of bits equal those holder by holder, on every SIMD target, for
// any holders and weights, and that holders keep their roots when more join.
#include "common/tree/root_holders.hpp"

#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>

namespace cd::tests {
namespace {

using Truth = std::set<std::pair<std::uint32_t, RootIndex>>;

constexpr std::uint32_t root_count = 70;

Truth set_some(std::mt19937_64& random, RootHolders& holders) {
    Truth truth;
    const std::uint64_t share = 1 + random() % 10;
    for (std::uint32_t holder = 0; holder < holders.holder_count(); ++holder) {
        for (RootIndex root = 0; root < root_count; ++root) {
            if (random() % 10 < share) {
                holders.set(holder, root);
                truth.emplace(holder, root);
            }
        }
    }
    return truth;
}

std::vector<WeightedRoot> some_roots(std::mt19937_64& random) {
    // Triangles per root; sums are around the sixteen bits added at once, and above them.
    constexpr std::uint64_t weights_max[] = {200, 3'000, 70'000, 50'000'000};
    const std::uint64_t weight_max = weights_max[random() % 4];
    std::vector<WeightedRoot> roots;
    for (RootIndex root = 0; root < root_count; ++root) {
        if (random() % 3 != 0) {
            roots.push_back({root, static_cast<std::uint32_t>(random() % weight_max)});
        }
    }
    return roots;
}

std::vector<std::uint64_t>
sums_of(const Truth& truth, std::span<const WeightedRoot> roots, std::size_t count) {
    std::vector<std::uint64_t> sums(count, 0);
    for (const auto& [holder, root] : truth) {
        for (const WeightedRoot& touched : roots) {
            sums[holder] += touched.root == root ? touched.weight : 0;
        }
    }
    return sums;
}

TEST(RootHolders, SumsAreThoseOfEachHolderOnEveryTarget) {
    on_every_target([](SimdTarget) {
        for (SeededRandom random : seeds(60)) {
            RootHolders holders(root_count, 1 + static_cast<std::uint32_t>(random() % 300));
            const Truth truth = set_some(random, holders);
            const auto roots = some_roots(random);
            const auto expected = sums_of(truth, roots, holders.sum_count());

            std::vector<std::uint64_t> sums(holders.sum_count(), 0);
            holders.add_held(roots, sums);
            ASSERT_EQ(sums, expected);
            holders.add_held(roots, sums);
            for (std::uint32_t holder = 0; holder < holders.holder_count(); ++holder) {
                ASSERT_EQ(holders.held(holder, roots), expected[holder]);
                ASSERT_EQ(sums[holder], 2 * expected[holder]) << "sums are added to";
            }
        }
    });
}

TEST(RootHolders, NewHoldersHoldNothingAndChangeNoOther) {
    std::mt19937_64 random(1);
    RootHolders holders(root_count, 3);
    const Truth truth = set_some(random, holders);
    for (const std::uint32_t count : {3u, 64u, 65u, 700u}) {
        holders.grow(count);
        for (std::uint32_t holder = 0; holder < count; ++holder) {
            for (RootIndex root = 0; root < root_count; ++root) {
                ASSERT_EQ(holders.holds(holder, root), truth.contains({holder, root}));
            }
        }
    }
}

// Two trees may have been added at different times, and their sums are added.
TEST(RootHolders, SumsAreEquallyLongHoweverTheHoldersCame) {
    RootHolders grown(1, 0);
    for (std::uint32_t holders = 1; holders <= 3000; ++holders) {
        grown.grow(holders);
        ASSERT_EQ(grown.sum_count(), RootHolders(1, holders).sum_count()) << holders;
    }
}

TEST(RootHolders, RemovingAHolderKeepsTheOthersRoots) {
    RootHolders holders(root_count, 130);
    for (const std::uint32_t holder : {63u, 64u, 129u}) {
        holders.set(holder, 5);
        holders.set(holder, 6);
    }
    holders.clear(64, 6);
    holders.clear_all(63);
    const std::vector<WeightedRoot> roots = {{5, 1}, {6, 10}};
    EXPECT_EQ(holders.held(63, roots), 0u);
    EXPECT_EQ(holders.held(64, roots), 1u);
    EXPECT_EQ(holders.held(129, roots), 11u);
}

} // namespace
} // namespace cd::tests
