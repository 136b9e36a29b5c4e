// Proves that repeating a scenario of a distance, of lines or of a motion gives the same record,
// and that the page gets its nearest pair, its hits, or the contacts at its event to draw.
#include "web/server/scenario_repeat.hpp"

#include "common/job/run_scenario.hpp"
#include "common/shots/line_hit.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

namespace {

class DrawnDistance : public testing::Test {
  protected:
    DrawnDistance() {
        query_.level = Level::Any;
        query_.question = Question::Distance;
    }

    /// Runs a scenario whose boxes have this gap along x, and repeats it with its record.
    [[nodiscard]] ScenarioView repeat(double gap) const {
        Scenario scenario;
        scenario.poses.b = translation_pose(1 + gap, 0, 0);
        const ScenarioRun first =
            ScenarioRunner(tree_, tree_, query_, PairStage::Float, {}).run(scenario);
        const KeptRecord record{encode_result(first.result), first.result};
        return repeat_scenario({tree_, tree_}, query_, scenario, record, {});
    }

    const ObbTree tree_ = make_tree(make_box({1, 1, 1}));
    Query query_;
};

} // namespace

TEST_F(DrawnDistance, ANearestPairIsDrawnAsANearOne) {
    const ScenarioView view = repeat(0.25);
    EXPECT_EQ(view.verified, true) << view.verify_note;
    ASSERT_NE(view.drawn, nullptr) << view.draw_note;
    ASSERT_EQ(view.drawn->pairs.size(), 1u);
    EXPECT_EQ(view.drawn->pairs[0].kind, PairClass::Near);
    EXPECT_EQ(view.drawn->near_distances, std::vector<double>{0.25});
    const Vec3 gap = view.drawn->points[1] - view.drawn->points[0];
    EXPECT_EQ(gap, Vec3(0.25, 0, 0));
    ASSERT_TRUE(view.result->nearest);
    EXPECT_EQ(view.result->nearest->distance, 0.25);
}

TEST_F(DrawnDistance, ContactsAreDrawnWithTheirPoints) {
    const ScenarioView view = repeat(-0.25);
    EXPECT_EQ(view.verified, true) << view.verify_note;
    ASSERT_NE(view.drawn, nullptr) << view.draw_note;
    EXPECT_GT(view.drawn->pairs.size(), 1u);
    EXPECT_FALSE(view.drawn->points.empty());
    EXPECT_EQ(view.drawn->near_count, 0u);
}

TEST_F(DrawnDistance, NothingIsDrawnBeyondTheBound) {
    query_.up_to = 0.125;
    const ScenarioView view = repeat(0.25);
    EXPECT_EQ(view.verified, true) << view.verify_note;
    ASSERT_NE(view.drawn, nullptr) << view.draw_note;
    EXPECT_TRUE(view.drawn->pairs.empty());
    EXPECT_FALSE(view.result->nearest);
}

namespace {

/// Two lines along x through a box about the origin, and one beside it.
class DrawnLines : public testing::Test {
  protected:
    DrawnLines() {
        query_.level = Level::Pairs;
        query_.question = Question::Shots;
    }

    /// Runs the scenario, and repeats it with its record.
    [[nodiscard]] ScenarioView repeat() const {
        const Scenario scenario;
        const ScenarioRun first =
            ScenarioRunner(box_, lines_, query_, PairStage::Float, {}).run(scenario);
        const KeptRecord record{encode_result(first.result), first.result};
        return repeat_scenario({box_, lines_}, query_, scenario, record, {});
    }

    const ObbTree box_ = make_tree(make_box({1, 1, 1}));
    const ObbTree lines_ = make_tree(make_mesh({Vec3(-2, 0.25, 0.125),
                                                Vec3(2, 0.25, 0.125),
                                                Vec3(-2, 0.125, 0.25),
                                                Vec3(2, 0.125, 0.25),
                                                Vec3(-2, 3, 3),
                                                Vec3(2, 3, 3)},
                                               {{0, 1, 1}, {2, 3, 3}, {4, 5, 5}}));
    Query query_;
};

} // namespace

TEST_F(DrawnLines, HitsAreDrawnAndVerified) {
    const ScenarioView view = repeat();
    EXPECT_EQ(view.verified, true) << view.verify_note;
    EXPECT_EQ(view.listed, 4u);
    EXPECT_TRUE(view.result->hits.empty()) << "the head alone is kept";
    ASSERT_NE(view.drawn, nullptr) << view.draw_note;
    ASSERT_EQ(view.drawn->hits.size(), 4u);
    EXPECT_EQ(view.drawn->hits.size(), view.drawn->pairs.size());
    for (const PairHit& hit : view.drawn->hits) {
        const bool enters = (hit.flags & hit_flag::front) != 0;
        EXPECT_EQ(hit.depth, enters ? 1.5 : 2.5);
    }
}

TEST_F(DrawnLines, AJobThatListsNoHitsIsRunAgainForThem) {
    query_.level = Level::Count;
    const ScenarioView view = repeat();
    EXPECT_EQ(view.verified, true) << view.verify_note;
    EXPECT_EQ(view.result->pair_count, 4u);
    EXPECT_EQ(view.listed, 0u);
    ASSERT_NE(view.drawn, nullptr) << view.draw_note;
    EXPECT_EQ(view.drawn->question, Question::Shots);
    EXPECT_EQ(view.drawn->hits.size(), 4u);
}

TEST_F(DrawnLines, ACutListIsDrawnWhole) {
    query_.limit_pairs = 1;
    const ScenarioView view = repeat();
    EXPECT_EQ(view.verified, true) << view.verify_note;
    EXPECT_EQ(view.listed, 1u);
    ASSERT_NE(view.drawn, nullptr) << view.draw_note;
    EXPECT_EQ(view.drawn->hits.size(), 4u);
}

TEST_F(DrawnLines, FirstHitsAreDrawnAloneIfTheJobAsksForThem) {
    query_.first_hits = true;
    for (const Level level : {Level::Count, Level::Pairs}) {
        query_.level = level;
        const ScenarioView view = repeat();
        EXPECT_EQ(view.verified, true) << view.verify_note;
        ASSERT_NE(view.drawn, nullptr) << view.draw_note;
        ASSERT_EQ(view.drawn->hits.size(), 2u);
        EXPECT_EQ(view.drawn->hits[0].depth, 1.5);
        EXPECT_EQ(view.drawn->hits[1].depth, 1.5);
    }
}

TEST_F(DrawnLines, ARecordOfOtherHitsIsNotVerified) {
    const Scenario scenario;
    ScenarioResult other =
        ScenarioRunner(box_, lines_, query_, PairStage::Float, {}).run(scenario).result;
    other.hits[0].depth = 1.25;
    const KeptRecord record{encode_result(other), other};
    const ScenarioView view = repeat_scenario({box_, lines_}, query_, scenario, record, {});
    EXPECT_EQ(view.verified, false);
    EXPECT_EQ(view.verify_note,
              "the record says contact with 4 hits, a second run here contact with 4 hits");
}

namespace {

/// A box with edges of length 1 that moves along x, from 2 beside another one.
class DrawnMotion : public testing::Test {
  protected:
    DrawnMotion() {
        query_.level = Level::Any;
        query_.question = Question::Motion;
        query_.motion = MotionQuery{0x1p-8, Until::Contact};
    }

    /// Runs a motion by `way` along x and to y, and repeats it with its record.
    [[nodiscard]] ScenarioView repeat(double way, double y = 0) const {
        Scenario scenario;
        scenario.poses = {moved_pose({0, 0, 0}), moved_pose({2, y, 0})};
        scenario.to = PosePair{moved_pose({0, 0, 0}), moved_pose({2 + way, y, 0})};
        const ScenarioRun first =
            ScenarioRunner(tree_, tree_, query_, PairStage::Float, {}).run(scenario);
        const KeptRecord record{encode_result(first.result), first.result};
        return repeat_scenario({tree_, tree_}, query_, scenario, record, {});
    }

    const ObbTree tree_ = make_tree(make_box({1, 1, 1}));
    Query query_;
};

} // namespace

TEST_F(DrawnMotion, TheContactsAtTheEventAreDrawnAtBothLevels) {
    for (const Level level : {Level::Any, Level::Pairs}) {
        query_.level = level;
        const ScenarioView view = repeat(-2);
        EXPECT_EQ(view.verified, true) << view.verify_note;
        ASSERT_TRUE(view.result->motion);
        EXPECT_EQ(view.result->motion->end, MotionEnd::Contact);
        ASSERT_TRUE(view.keys);
        EXPECT_EQ(view.keys->from.b.translation(), Vec3(2, 0, 0));
        EXPECT_EQ(view.keys->to.b.translation(), Vec3(0, 0, 0));
        EXPECT_EQ(view.poses.b.translation(), Vec3(1, 0, 0)) << "at the event";
        ASSERT_NE(view.drawn, nullptr) << view.draw_note;
        EXPECT_FALSE(view.drawn->pairs.empty());
        EXPECT_EQ(view.drawn->pairs.size(), view.drawn->pair_count);
        EXPECT_FALSE(view.drawn->points.empty());
    }
}

TEST_F(DrawnMotion, AFreeMotionHasNoPairs) {
    const ScenarioView view = repeat(2);
    EXPECT_EQ(view.verified, true) << view.verify_note;
    EXPECT_EQ(view.result->kind, ScenarioClass::Separate);
    ASSERT_NE(view.drawn, nullptr) << view.draw_note;
    EXPECT_TRUE(view.drawn->pairs.empty());
}

TEST_F(DrawnMotion, AnUndecidedMotionIsVerified) {
    query_.motion->resolution = 0.5;
    // The boxes slide past each other, nearer than the resolution.
    const ScenarioView view = repeat(-4, 1.0625);
    EXPECT_EQ(view.result->kind, ScenarioClass::Undecided);
    EXPECT_EQ(view.verified, true) << view.verify_note;
    ASSERT_NE(view.drawn, nullptr) << view.draw_note;
}

TEST_F(DrawnMotion, ARecordOfAnotherBracketIsNotVerified) {
    Scenario scenario;
    scenario.poses = {moved_pose({0, 0, 0}), moved_pose({2, 0, 0})};
    scenario.to = PosePair{moved_pose({0, 0, 0}), moved_pose({0, 0, 0})};
    ScenarioResult other =
        ScenarioRunner(tree_, tree_, query_, PairStage::Float, {}).run(scenario).result;
    other.motion->t1 += 1;
    const KeptRecord record{encode_result(other), other};
    const ScenarioView view = repeat_scenario({tree_, tree_}, query_, scenario, record, {});
    EXPECT_EQ(view.verified, false);
    EXPECT_NE(view.verify_note.find("a second run here contact with 0 pairs in ["),
              std::string::npos)
        << view.verify_note;
}

} // namespace cd::tests
