// Proves that a scenario of the question of the distance is verified, and drawn with its nearest
// pair.
#include "web/server/scenario_repeat.hpp"

#include "common/job/run_scenario.hpp"
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
        return repeat_scenario(tree_, tree_, query_, scenario, record, {});
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

} // namespace cd::tests
