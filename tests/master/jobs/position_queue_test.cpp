// Proves that every position of a job is handed out once, and that returned positions are handed
// out again first, with their losses.
#include "master/jobs/position_queue.hpp"

#include "common/core/limits/engine.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(PositionQueue, HandsOutEveryPlaceOnceAndNoPieceLeavesItsWindow) {
    const std::uint64_t window = limits::order_window_scenarios;
    PositionQueue queue(2 * window + 5);
    std::uint64_t next = 0;
    while (!queue.empty()) {
        EXPECT_EQ(queue.left(), 2 * window + 5 - next);
        const auto piece = queue.take(10'000);
        EXPECT_EQ(piece.positions.first, next);
        EXPECT_LE(piece.positions.count, 10'000u);
        EXPECT_EQ(piece.positions.first / window, (piece.positions.end() - 1) / window);
        EXPECT_TRUE(piece.losses.none());
        next = piece.positions.end();
    }
    EXPECT_EQ(next, 2 * window + 5);
    EXPECT_EQ(queue.left(), 0u);
}

TEST(PositionQueue, ReturnedPositionsGoFirst) {
    PositionQueue queue(100);
    const auto first = queue.take(10);
    Losses one;
    one.add(70);
    queue.put_back({{3, 4}, one});
    EXPECT_EQ(queue.left(), 94u);
    EXPECT_EQ(queue.front().losses, one);
    const auto again = queue.take(100);
    EXPECT_EQ(again.positions, (PositionRange{3, 4}));
    EXPECT_EQ(again.losses, one);
    EXPECT_EQ(queue.take(1).positions.first, first.positions.end());
}

TEST(PositionQueue, WhatWasLostBeforeKeepsItsLosses) {
    const std::vector<LostPositions> lost = {
        {{20, 10}, 70}, {{25, 1}, 71}, {{28, 12}, 72}, {{99, 1}, 70}};
    PositionQueue queue(100, lost);
    EXPECT_EQ(queue.left(), 100u);
    std::uint64_t next = 0;
    while (!queue.empty()) {
        const auto piece = queue.take(1);
        EXPECT_EQ(piece.positions, (PositionRange{next, 1}));
        Losses losses;
        for (const LostPositions& one : lost) {
            if (next >= one.positions.first && next < one.positions.end()) {
                losses.add(one.process);
            }
        }
        EXPECT_EQ(piece.losses, losses) << next;
        ++next;
    }
    EXPECT_EQ(next, 100u);
}

TEST(PositionQueue, AFullyLostQueueIsOnePiece) {
    const std::vector<LostPositions> lost = {{{0, 100}, 70}};
    PositionQueue queue(100, lost);
    ASSERT_EQ(queue.pieces().size(), 1u);
    EXPECT_EQ(queue.front().positions, (PositionRange{0, 100}));
    EXPECT_EQ(queue.front().losses.count(), 1u);
}

TEST(PositionQueue, OfNoScenariosIsEmpty) {
    EXPECT_TRUE(PositionQueue(0).empty());
    EXPECT_TRUE(PositionQueue().empty());
}

} // namespace
} // namespace cd::tests
