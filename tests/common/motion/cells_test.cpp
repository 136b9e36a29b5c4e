// Proves that the search over cells finds the free and the open leaves that the definition names,
// and ends where it should; with a point that moves along a line of walls, whose distance is known.

#include "common/motion/cells.hpp"

#include "common/core/limits/engine.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

namespace cd::tests {

namespace {

/// A closed interval of x.
struct Wall {
    double low;
    double high;
};

using Walls = std::vector<Wall>;

double gap_at(double x, const Walls& walls) {
    double gap = std::numeric_limits<double>::max();
    for (const Wall& wall : walls) {
        gap = std::min(gap, std::max({wall.low - x, x - wall.high, 0.0}));
    }
    return gap;
}

CellQuestions questions_about(const Walls& walls, double clearance) {
    const auto gap = [walls](const PosePair& poses) {
        return gap_at(poses.b.translation().x(), walls);
    };
    return {[gap](const PosePair& poses, double distance) { return gap(poses) <= distance; },
            [gap, clearance](const PosePair& poses) { return gap(poses) <= clearance; }};
}

/// Moves a point from x = 0 to 8, so that M of a cell of level k is slightly above 4 / 2^k.
Motion along_x(unsigned depth) {
    const Pose rest = moved_pose({0, 0, 0});
    const double resolution = std::ldexp(4 * (1 + 0x1p-30), -static_cast<int>(depth));
    return make_motion({rest, rest}, {rest, moved_pose({8, 0, 0})}, {0, 0}, resolution);
}

MotionAnswer search(const Walls& walls, Until until, double clearance = 0) {
    return search_cells(along_x(5), until, clearance, questions_about(walls, clearance));
}

using Runs = std::vector<CellRun>;

TEST(SearchCells, TheFirstContactIsBracketed) {
    // The leaf before the wall is open, since its middle is exactly M away.
    const MotionAnswer answer = search({{5, 5.5}}, Until::Contact);
    EXPECT_EQ(answer.depth, 5u);
    EXPECT_EQ(answer.end, MotionEnd::Contact);
    EXPECT_EQ(answer.t0, 19u);
    EXPECT_EQ(answer.t1, 20u);
    EXPECT_EQ(answer.runs, (Runs{{CellState::Free, 0, 19}, {CellState::Open, 19, 1, 20, 20}}));
    EXPECT_GE(answer.open_within, 0.125);
    EXPECT_LE(answer.open_within, 0.125 * (1 + 0x1p-30));
}

TEST(SearchCells, HalvedCellsAndLeavesAreTheCellsTested) {
    const MotionAnswer answer = search({{5, 5.5}}, Until::End);
    EXPECT_EQ(answer.cells, 2 * answer.leaves - 1) << "each halved cell has two halves";
    EXPECT_GT(answer.leaves, 4u);
}

TEST(SearchCells, TheWholeTimeIsInRuns) {
    const MotionAnswer answer = search({{5, 5.5}}, Until::End);
    EXPECT_EQ(answer.end, MotionEnd::Contact);
    EXPECT_EQ(answer.t0, 19u);
    EXPECT_EQ(answer.t1, 20u);
    EXPECT_EQ(answer.runs,
              (Runs{{CellState::Free, 0, 19},
                    {CellState::Open, 19, 4, 20, 22},
                    {CellState::Free, 23, 9}}));
}

TEST(SearchCells, WithoutWallsOneCellIsEnough) {
    for (const Until until : {Until::Contact, Until::End}) {
        const MotionAnswer answer = search({{20, 21}}, until);
        EXPECT_EQ(answer.end, MotionEnd::Free);
        EXPECT_EQ(answer.runs, (Runs{{CellState::Free, 0, 32}}));
        EXPECT_EQ(answer.cells, 1u);
        EXPECT_EQ(answer.leaves, 1u);
        EXPECT_EQ(answer.t0, 32u);
        EXPECT_EQ(answer.t1, 32u);
        EXPECT_EQ(answer.open_within, 0);
    }
}

TEST(SearchCells, AContactAtTheStartIsSaid) {
    const Walls walls{{-1, 1}};
    const MotionAnswer first = search(walls, Until::Contact);
    EXPECT_EQ(first.end, MotionEnd::Start);
    EXPECT_EQ(first.t1, 0u);
    EXPECT_EQ(first.runs, Runs{});
    const MotionAnswer whole = search(walls, Until::End);
    EXPECT_EQ(whole.end, MotionEnd::Start);
    EXPECT_EQ(whole.t1, 0u);
    EXPECT_EQ(whole.runs, (Runs{{CellState::Open, 0, 5, 0, 4}, {CellState::Free, 5, 27}}));
}

TEST(SearchCells, TheWayOutIsBracketed) {
    const MotionAnswer answer = search({{-1, 1}, {3, 4}}, Until::Free);
    EXPECT_EQ(answer.end, MotionEnd::Free);
    EXPECT_EQ(answer.t0, 4u);
    EXPECT_EQ(answer.t1, 5u);
    EXPECT_EQ(answer.runs, (Runs{{CellState::Open, 0, 5, 0, 4}, {CellState::Free, 5, 1}}));
}

TEST(SearchCells, ThereMayBeNoWayOut) {
    const MotionAnswer answer = search({{-1, 9}}, Until::Free);
    EXPECT_EQ(answer.end, MotionEnd::Contact);
    EXPECT_EQ(answer.t0, 32u);
    EXPECT_EQ(answer.t1, 32u);
    EXPECT_EQ(answer.runs, (Runs{{CellState::Open, 0, 32, 0, 32}}));
}

TEST(SearchCells, AFreeStartIsTheWayOut) {
    const MotionAnswer answer = search({{5, 5.5}}, Until::Free);
    EXPECT_EQ(answer.end, MotionEnd::Free);
    EXPECT_EQ(answer.t0, 0u);
    EXPECT_EQ(answer.t1, 0u);
    EXPECT_EQ(answer.runs, (Runs{{CellState::Free, 0, 16}}));
}

TEST(SearchCells, AWallBetweenTwoInstantsLeavesAnOpenRun) {
    for (const Until until : {Until::Contact, Until::End}) {
        const MotionAnswer answer = search({{5.1, 5.2}}, until);
        EXPECT_EQ(answer.end, MotionEnd::Free);
        EXPECT_EQ(
            answer.runs,
            (Runs{{CellState::Free, 0, 20}, {CellState::Open, 20, 1}, {CellState::Free, 21, 11}}));
        EXPECT_FALSE(answer.runs[1].has_event());
        EXPECT_EQ(answer.t0, 32u);
        EXPECT_GE(answer.open_within, 0.125);
    }
}

TEST(SearchCells, AClearanceMovesTheEvent) {
    const MotionAnswer answer = search({{5, 5.5}}, Until::Contact, 0.5);
    EXPECT_EQ(answer.end, MotionEnd::Contact);
    EXPECT_EQ(answer.t0, 17u);
    EXPECT_EQ(answer.t1, 18u);
    EXPECT_GE(answer.open_within, 0.625);
    const MotionAnswer far = search({{8.5, 9}}, Until::Contact, 0x1.fffffffffffffp-2);
    EXPECT_EQ(far.end, MotionEnd::Free);
}

TEST(SearchCells, NoInstantIsAskedTwice) {
    std::set<double> asked;
    CellQuestions questions = questions_about({{1, 2}, {5.1, 5.2}}, 0);
    questions.is_event = [&, is_event = questions.is_event](const PosePair& poses) {
        EXPECT_TRUE(asked.insert(poses.b.translation().x()).second);
        return is_event(poses);
    };
    EXPECT_EQ(search_cells(along_x(5), Until::End, 0, questions).end, MotionEnd::Contact);
    EXPECT_GT(asked.size(), 5u);
}

TEST(SearchCells, TooManyCellsEndTheAnswer) {
    for (const Until until : {Until::Contact, Until::Free, Until::End}) {
        CellQuestions questions = questions_about({{-1, 9}}, 0);
        questions.is_event = [](const PosePair&) { return false; };
        const MotionAnswer answer = search_cells(along_x(19), until, 0, questions);
        EXPECT_EQ(answer.end, MotionEnd::Limit);
        EXPECT_EQ(answer.cells, limits::motion_cells_max);
        ASSERT_EQ(answer.runs.size(), 1u);
        EXPECT_EQ(answer.runs[0].state, CellState::Open);
        // Half of the cells of a full binary tree are leaves.
        EXPECT_GT(answer.t1, limits::motion_cells_max / 2 - 20);
        EXPECT_EQ(answer.t1, answer.runs[0].end());
        EXPECT_EQ(answer.t0, answer.t1);
    }
}

TEST(SearchCells, AStopEndsIt) {
    int polls = 0;
    CellQuestions questions = questions_about({{5, 5.5}}, 0);
    questions.stop = [&] { return ++polls > 3; };
    EXPECT_TRUE(search_cells(along_x(5), Until::End, 0, questions).is_stopped);
    EXPECT_EQ(polls, 4);
}

/// The open leaves by the definition: those which no free cell of any level contains.
std::vector<bool> open_leaves(const Motion& motion, const CellQuestions& questions) {
    std::vector<bool> are_open(std::size_t{1} << motion.depth(), true);
    for (unsigned level = 0; level <= motion.depth(); ++level) {
        for (std::uint32_t index = 0; index < 1u << level; ++index) {
            double bound = motion.bound();
            for (unsigned above = 1; above <= level; ++above) {
                bound = motion.bound({above, index >> (level - above)}, bound);
            }
            if (!questions.is_within(motion.at_middle({level, index}), bound)) {
                const std::size_t width = are_open.size() >> level;
                std::fill_n(
                    are_open.begin() + static_cast<std::ptrdiff_t>(index * width), width, false);
            }
        }
    }
    return are_open;
}

TEST(SearchCells, FindsTheLeavesOfTheDefinition) {
    std::uint64_t runs = 0;
    for (SeededRandom random : seeds(100)) {
        Walls walls;
        for (int i = 0; i < 4; ++i) {
            const double low = uniform(random, -1, 9);
            walls.push_back({low, low + uniform(random, 0, 0.5)});
        }
        const Motion motion = along_x(8);
        const CellQuestions questions = questions_about(walls, 0);
        const MotionAnswer answer = search_cells(motion, Until::End, 0, questions);
        const std::vector<bool> expected = open_leaves(motion, questions);
        std::uint32_t next = 0;
        for (const CellRun& run : answer.runs) {
            EXPECT_EQ(run.first, next);
            next = run.end();
            const bool is_open = run.state == CellState::Open;
            for (std::uint32_t leaf = run.first; leaf < run.end(); ++leaf) {
                EXPECT_EQ(expected[leaf], is_open) << leaf;
            }
        }
        EXPECT_EQ(next, expected.size());
        runs += answer.runs.size();
    }
    EXPECT_GT(runs, 500u);
}

} // namespace

} // namespace cd::tests
