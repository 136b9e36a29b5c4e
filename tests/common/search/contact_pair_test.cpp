// Proves that pairs are sorted, whatever their number and ids, and that each keeps its corners.

#include "common/search/contact_pair.hpp"

#include "common/core/limits/engine.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace cd::tests {

namespace {

std::vector<ContactPair>
random_pairs(std::mt19937_64& random, std::size_t count, std::uint64_t places) {
    std::vector<ContactPair> pairs;
    for (std::size_t i = 0; i < count; ++i) {
        // From both ends of the range of triangle ids.
        const std::uint64_t last = limits::mesh_triangles_max - 1;
        const auto place = [&] {
            const std::uint64_t from_end = random() % places;
            return static_cast<std::uint32_t>(random() % 2 == 0 ? from_end : last - from_end);
        };
        pairs.push_back({place(), place(), static_cast<PairClass>(1 + random() % 3)});
    }
    return pairs;
}

Corners corners_of(const ContactPair& pair, double which) {
    const Vec3 corner(pair.a, pair.b, which);
    return {corner, corner, corner};
}

} // namespace

TEST(PairSorter, PutsPairsInTheirOrderOnEverySimdTarget) {
    on_every_target([](SimdTarget) {
        std::mt19937_64 random(1);
        PairSorter sorter;
        for (const std::size_t count : {0u, 1u, 2u, 3u, 17u, 100u, 528u, 5'000u}) {
            for (const std::uint64_t places : {3ull, 50ull, 1ull << 31}) {
                std::vector<ContactPair> pairs = random_pairs(random, count, places);
                std::vector<ContactPair> expected = pairs;
                std::sort(expected.begin(), expected.end());
                sorter.sort(pairs);
                EXPECT_EQ(pairs, expected);
            }
        }
    });
}

TEST(PairSorter, KeepsEachPairsCornersBesideIt) {
    std::mt19937_64 random(2);
    PairSorter sorter;
    for (const std::size_t count : {0u, 1u, 5u, 300u, 2'000u}) {
        std::vector<ContactPair> pairs = random_pairs(random, count, 1ull << 31);
        std::vector<PairCorners> corners;
        for (const ContactPair& pair : pairs) {
            corners.push_back({corners_of(pair, 0), corners_of(pair, 1)});
        }
        std::vector<ContactPair> expected = pairs;
        std::sort(expected.begin(), expected.end());
        sorter.sort(pairs, corners);
        ASSERT_EQ(pairs, expected);
        ASSERT_EQ(corners.size(), count);
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_EQ(corners[i].a, corners_of(pairs[i], 0));
            ASSERT_EQ(corners[i].b, corners_of(pairs[i], 1));
        }
    }
}

} // namespace cd::tests
