// Proves that every position of a job is handed out once, and that returned positions are handed
// out again first, with their losses.
#include "master/jobs/place_queue.hpp"

#include "common/core/limits/engine.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(PlaceQueue, HandsOutEveryPlaceOnceAndNoPieceLeavesItsWindow) {
    const std::uint64_t window = limits::order_window_scenarios;
    PlaceQueue queue(2 * window + 5);
    std::uint64_t next = 0;
    while (!queue.empty()) {
        EXPECT_EQ(queue.left(), 2 * window + 5 - next);
        const auto piece = queue.take(10'000);
        EXPECT_EQ(piece.places.first, next);
        EXPECT_LE(piece.places.count, 10'000u);
        EXPECT_EQ(piece.places.first / window, (piece.places.end() - 1) / window);
        EXPECT_TRUE(piece.losses.none());
        next = piece.places.end();
    }
    EXPECT_EQ(next, 2 * window + 5);
    EXPECT_EQ(queue.left(), 0u);
}

TEST(PlaceQueue, ReturnedPositionsGoFirst) {
    PlaceQueue queue(100);
    const auto first = queue.take(10);
    Losses one;
    one.add(70);
    queue.put_back({{3, 4}, one});
    EXPECT_EQ(queue.left(), 94u);
    EXPECT_EQ(queue.front().losses, one);
    const auto again = queue.take(100);
    EXPECT_EQ(again.places, (PlaceRange{3, 4}));
    EXPECT_EQ(again.losses, one);
    EXPECT_EQ(queue.take(1).places.first, first.places.end());
}

TEST(PlaceQueue, WhatWasLostBeforeKeepsItsLosses) {
    const std::vector<LostPlaces> lost = {
        {{20, 10}, 70}, {{25, 1}, 71}, {{28, 12}, 72}, {{99, 1}, 70}};
    PlaceQueue queue(100, lost);
    EXPECT_EQ(queue.left(), 100u);
    std::uint64_t next = 0;
    while (!queue.empty()) {
        const auto piece = queue.take(1);
        EXPECT_EQ(piece.places, (PlaceRange{next, 1}));
        Losses losses;
        for (const LostPlaces& one : lost) {
            if (next >= one.places.first && next < one.places.end()) {
                losses.add(one.process);
            }
        }
        EXPECT_EQ(piece.losses, losses) << next;
        ++next;
    }
    EXPECT_EQ(next, 100u);
}

TEST(PlaceQueue, AFullyLostQueueIsOnePiece) {
    const std::vector<LostPlaces> lost = {{{0, 100}, 70}};
    PlaceQueue queue(100, lost);
    ASSERT_EQ(queue.pieces().size(), 1u);
    EXPECT_EQ(queue.front().places, (PlaceRange{0, 100}));
    EXPECT_EQ(queue.front().losses.count(), 1u);
}

TEST(PlaceQueue, OfNoScenariosIsEmpty) {
    EXPECT_TRUE(PlaceQueue(0).empty());
    EXPECT_TRUE(PlaceQueue().empty());
}

TEST(PlaceQueueParts, WithoutAHoleARunHasUpToTwoParts) {
    const std::vector<PlaceRange> runs{{0, 10}, {20, 10}};
    using Runs = std::vector<PlaceRange>;
    EXPECT_EQ(without(runs, {10, 10}), runs);
    EXPECT_EQ(without(runs, {3, 2}), (Runs{{0, 3}, {5, 5}, {20, 10}}));
    EXPECT_EQ(without(runs, {5, 20}), (Runs{{0, 5}, {25, 5}}));
    EXPECT_EQ(without(runs, {0, 10}), (Runs{{20, 10}}));
    EXPECT_EQ(without(runs, {0, 40}), Runs{});
    EXPECT_EQ(without(runs, {30, 0}), runs);
}

TEST(PlaceRuns, ConsecutivePositionsAreJoined) {
    PlaceRuns runs;
    for (const std::uint64_t place : {3, 4, 5, 7, 9, 10}) {
        runs.add(place);
    }
    EXPECT_EQ(runs.take(), (std::vector<PlaceRange>{{3, 3}, {7, 1}, {9, 2}}));
    EXPECT_TRUE(PlaceRuns().take().empty());
}

} // namespace
} // namespace cd::tests
