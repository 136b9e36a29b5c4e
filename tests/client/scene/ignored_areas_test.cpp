// Proves that subtracting a range leaves exactly the other pairs, each in one range.
#include "client/scene/ignored_areas.hpp"

#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace cd::tests {

namespace {

using Pairs = std::multiset<std::pair<std::uint32_t, std::uint32_t>>;

Pairs pairs_of(const IgnoredAreas& areas) {
    Pairs pairs;
    for (const IgnoredRange& area : areas) {
        for (std::uint32_t a = area.a_begin; a < area.a_end; ++a) {
            for (std::uint32_t b = area.b_begin; b < area.b_end; ++b) {
                pairs.emplace(a, b);
            }
        }
    }
    return pairs;
}

IgnoredRange random_range(std::mt19937_64& random) {
    const auto number = [&] { return static_cast<std::uint32_t>(random() % 8); };
    IgnoredRange range{number(), number(), number(), number(), 3, 5};
    if (range.a_begin > range.a_end) {
        std::swap(range.a_begin, range.a_end);
    }
    if (range.b_begin > range.b_end) {
        std::swap(range.b_begin, range.b_end);
    }
    return range;
}

} // namespace

TEST(IgnoredAreas, LoseExactlyThePairsOfAHole) {
    for (SeededRandom random : seeds(raised(300))) {
        IgnoredAreas areas{{0, 8, 0, 8, 3, 5}};
        for (int round = 0; round < 4; ++round) {
            const IgnoredRange hole = random_range(random);
            Pairs expected = pairs_of(areas);
            std::erase_if(expected, [&](const auto& pair) {
                return hole.a_begin <= pair.first && pair.first < hole.a_end &&
                       hole.b_begin <= pair.second && pair.second < hole.b_end;
            });
            subtract(areas, hole);
            // A multiset, so that a pair in two ranges would show.
            EXPECT_EQ(pairs_of(areas), expected);
            for (const IgnoredRange& area : areas) {
                EXPECT_EQ(area.body_a, 3u);
                EXPECT_EQ(area.body_b, 5u);
            }
        }
    }
}

} // namespace cd::tests
