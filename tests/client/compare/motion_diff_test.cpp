// Proves that motions count as changed if their class or their bracket differs, and only then.
#include "client/compare/scenario_diff.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace cd::tests {

namespace {

ScenarioResult motion(Until until, ScenarioClass kind, MotionEnd end, std::vector<CellRun> runs) {
    ScenarioResult result;
    result.question = Question::Motion;
    result.level = Level::Any;
    result.kind = kind;
    result.motion = MotionOutcome{until, 2, end, 0, 0, std::move(runs)};
    return result;
}

/// First in contact in [first, first + 1] of 4 units.
ScenarioResult hit(Until until, std::uint32_t first) {
    ScenarioResult result =
        motion(until,
               ScenarioClass::Contact,
               MotionEnd::Contact,
               {{CellState::Free, 0, first}, {CellState::Open, first, 1, first + 1, first + 1}});
    result.motion->t0 = first;
    result.motion->t1 = first + 1;
    return result;
}

/// Free for all of the time; searches for the way out end at its begin.
ScenarioResult passing(Until until) {
    ScenarioResult result =
        motion(until, ScenarioClass::Separate, MotionEnd::Free, {{CellState::Free, 0, 4}});
    result.motion->t0 = result.motion->t1 = until == Until::Free ? 0 : 4;
    return result;
}

/// In contact until `last` of 4 units, and free a unit later.
ScenarioResult leaving(std::uint32_t last) {
    ScenarioResult result =
        motion(Until::Free,
               ScenarioClass::Contact,
               MotionEnd::Free,
               {{CellState::Open, 0, last + 1, 0, last}, {CellState::Free, last + 1, 1}});
    result.motion->t0 = last;
    result.motion->t1 = last + 1;
    return result;
}

/// Returns the instants of a result twice as fine.
ScenarioResult finer(ScenarioResult result) {
    MotionOutcome& outcome = *result.motion;
    outcome.depth = 3;
    outcome.t0 *= 2;
    outcome.t1 *= 2;
    return result;
}

bool is_changed(const ScenarioResult& was, const ScenarioResult& is) {
    ScenarioDiff diff(std::nullopt, {false, {"a", "b"}});
    EXPECT_TRUE(diff.add({0, 0, &was, &is}));
    return diff.counts().changed == 1;
}

} // namespace

TEST(MotionDiff, AnotherBracketIsAChange) {
    const ScenarioResult was = hit(Until::Contact, 1);
    EXPECT_FALSE(is_changed(was, was));
    EXPECT_FALSE(is_changed(was, finer(was)));
    EXPECT_FALSE(is_changed(was, hit(Until::End, 1)));
    EXPECT_TRUE(is_changed(was, hit(Until::Contact, 2)));
    ScenarioResult narrower = finer(was);
    ++narrower.motion->t0;
    EXPECT_TRUE(is_changed(was, narrower));
    ScenarioResult started = was;
    started.motion->end = MotionEnd::Start;
    EXPECT_TRUE(is_changed(was, started));
    EXPECT_FALSE(is_changed(leaving(1), leaving(1)));
    EXPECT_TRUE(is_changed(leaving(1), leaving(2)));
}

TEST(MotionDiff, AnotherClassIsAChange) {
    EXPECT_TRUE(is_changed(passing(Until::Contact), hit(Until::Contact, 1)));
    ScenarioResult open = motion(Until::Contact,
                                 ScenarioClass::Undecided,
                                 MotionEnd::Free,
                                 {{CellState::Open, 0, 1}, {CellState::Free, 1, 3}});
    open.motion->t0 = open.motion->t1 = 4;
    EXPECT_TRUE(is_changed(passing(Until::Contact), open));
    EXPECT_TRUE(is_changed(open, hit(Until::Contact, 1)));
    EXPECT_FALSE(is_changed(open, open));
}

TEST(MotionDiff, SearchesForOtherThingsHaveNoCommonBracket) {
    EXPECT_FALSE(is_changed(passing(Until::Contact), passing(Until::Free)));
    EXPECT_FALSE(is_changed(hit(Until::Contact, 1), leaving(1)));
    EXPECT_TRUE(is_changed(passing(Until::Contact), leaving(1))) << "the class differs";
}

} // namespace cd::tests
