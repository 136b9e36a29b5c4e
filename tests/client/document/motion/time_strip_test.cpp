// Proves that a motion's line shows the worst of each part of its time, even of instants.
#include "client/document/motion/time_strip.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;

/// Returns the states as letters, a cell each.
std::string letters(const TimeStrip& strip) {
    std::string text;
    for (std::size_t i = 0; i < TimeStrip::cells; ++i) {
        text += "-fonc"[static_cast<std::size_t>(strip.at(i))];
    }
    return text;
}

MotionOutcome outcome(unsigned depth, std::vector<CellRun> runs) {
    MotionOutcome motion;
    motion.depth = depth;
    motion.runs = std::move(runs);
    return motion;
}

std::string times(std::size_t count, char letter) {
    return std::string(count, letter);
}

} // namespace

TEST(TimeStrip, ShowsRunsAndTheEvent) {
    const MotionOutcome motion = outcome(
        2, {{CellState::Free, 0, 1}, {CellState::Open, 1, 2, 2, 3}, {CellState::Free, 3, 1}});
    EXPECT_EQ(letters(TimeStrip(motion, false)),
              times(64, 'f') + times(64, 'o') + times(64, 'c') + times(64, 'f'));
    EXPECT_EQ(letters(TimeStrip(motion, true)),
              times(64, 'f') + times(64, 'o') + times(64, 'n') + times(64, 'f'));
}

TEST(TimeStrip, ShowsAnInstantAndWhereTheSearchEnded) {
    const MotionOutcome motion =
        outcome(2, {{CellState::Free, 0, 1}, {CellState::Open, 1, 1, 2, 2}});
    EXPECT_EQ(letters(TimeStrip(motion, false)),
              times(64, 'f') + times(64, 'o') + "c" + times(127, '-'));
    const MotionOutcome at_end =
        outcome(2, {{CellState::Free, 0, 3}, {CellState::Open, 3, 1, 4, 4}});
    EXPECT_EQ(letters(TimeStrip(at_end, false)), times(192, 'f') + times(63, 'o') + "c");
    EXPECT_EQ(letters(TimeStrip(outcome(0, {{CellState::Open, 0, 1, 0, 0}}), false)),
              "c" + times(255, 'o'));
}

TEST(TimeStrip, ShowsContactFromTheBeginWithoutARun) {
    MotionOutcome motion = outcome(3, {});
    motion.end = MotionEnd::Start;
    EXPECT_EQ(letters(TimeStrip(motion, false)), "c" + times(255, '-'));
}

TEST(TimeStrip, ACellHasTheWorstOfItsTime) {
    // 2^19 units, so that a cell has 2048 of them; one of cell 3 is open.
    const MotionOutcome motion = outcome(19,
                                         {{CellState::Free, 0, 3 * 2048 + 7},
                                          {CellState::Open, 3 * 2048 + 7, 1},
                                          {CellState::Free, 3 * 2048 + 8, 524288 - 3 * 2048 - 8}});
    EXPECT_EQ(letters(TimeStrip(motion, false)), "fffo" + times(252, 'f'));
}

TEST(TimeStrip, IsDrawnInAsManyPathsAsStates) {
    const MotionOutcome motion =
        outcome(2, {{CellState::Free, 0, 1}, {CellState::Open, 1, 1, 2, 2}});
    const std::string svg = TimeStrip(motion, false).svg().markup();
    EXPECT_THAT(svg, HasSubstr("<path class=\"m1\" d=\"M0 0h64v8h-64z\"></path>"));
    EXPECT_THAT(svg, HasSubstr("<path class=\"m2\" d=\"M64 0h64v8h-64z\"></path>"));
    EXPECT_THAT(svg, HasSubstr("<path class=\"m4\" d=\"M128 0h1v8h-1z\"></path>"));
    EXPECT_THAT(svg, Not(HasSubstr("m3")));
    EXPECT_THAT(
        svg,
        HasSubstr("aria-label=\"not searched 49.6 %, free 25 %, open 25 %, in contact 0.391 %\""));
    EXPECT_THAT(TimeStrip::style_sheet(), HasSubstr(".m4{fill:#c8201e}"));
}

} // namespace cd::tests
