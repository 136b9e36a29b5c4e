// Proves that a sweep finds each pair of boxes of two lists once, also where many begin at one
// place, against all pairs.

#include "common/scene/sorted_boxes.hpp"

#include "tests/common/scene/box_pairs.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cd::tests {

namespace {

constexpr std::array<std::size_t, 3> axes{1, 2, 0};

/// Boxes whose low and high ends are small integers, so that many of them are equal.
std::vector<WorldBox> make_boxes(std::mt19937_64& random, std::size_t count) {
    std::vector<WorldBox> boxes(count);
    for (WorldBox& box : boxes) {
        for (std::size_t k = 0; k < 3; ++k) {
            box.low[k] = static_cast<float>(random() % 8);
            box.high[k] = box.low[k] + static_cast<float>(random() % 3);
        }
    }
    return boxes;
}

SortedBoxes sorted(std::span<const WorldBox> boxes, std::vector<std::uint32_t> bodies) {
    std::ranges::sort(bodies, {}, [&](std::uint32_t body) { return boxes[body].low[axes[0]]; });
    return {boxes, bodies, axes};
}

std::vector<BodyPair> sorted_pairs(PairCollector& collector) {
    std::vector<BodyPair> pairs;
    for (const std::uint32_t key : collector.take()) {
        pairs.push_back({key >> 16, key & 0xFFFFu});
    }
    std::ranges::sort(pairs);
    return pairs;
}

} // namespace

TEST(SortedBoxes, FindPairsWithinAListAndBetweenTwo) {
    std::size_t found = 0;
    on_every_target([&](SimdTarget) {
        for (SeededRandom random : seeds(raised(60))) {
            const std::vector<WorldBox> boxes = make_boxes(random, 2 + random() % 120);
            std::array<std::vector<std::uint32_t>, 2> bodies;
            std::vector<std::size_t> list_of;
            for (std::uint32_t body = 0; body < boxes.size(); ++body) {
                list_of.push_back(random() % 3 == 0 ? 1 : 0);
                bodies.at(list_of.back()).push_back(body);
            }
            const std::array lists{sorted(boxes, bodies[0]), sorted(boxes, bodies[1])};
            std::vector<BodyPair> within;
            std::vector<BodyPair> between;
            for (const BodyPair pair : all_overlaps(boxes)) {
                if (list_of[pair.a] != list_of[pair.b]) {
                    between.push_back(pair);
                } else if (list_of[pair.a] == 0) {
                    within.push_back(pair);
                }
            }
            PairCollector collector;
            collector.add_within(lists[0]);
            EXPECT_EQ(sorted_pairs(collector), within);
            collector.add_between(lists[0], lists[1]);
            EXPECT_EQ(sorted_pairs(collector), between);
            found += within.size() + between.size();
        }
    });
    EXPECT_GT(found, 10000u);
}

TEST(SortedBoxes, OfAnEmptyListMeetNothing) {
    const std::vector<WorldBox> boxes(3);
    const SortedBoxes some = sorted(boxes, {0, 1, 2});
    const SortedBoxes none = sorted(boxes, {});
    PairCollector collector;
    collector.add_within(none);
    collector.add_between(some, none);
    collector.add_between(none, some);
    EXPECT_TRUE(sorted_pairs(collector).empty());
}

} // namespace cd::tests
